// The key tables are consistent: with themselves, with the defaults of the structs that they fill,
// and with the limits of the rooms below.
#include "gearwright/catalogue/key.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "gearwright/catalogue/compensate_keys.hpp"
#include "gearwright/catalogue/drive_keys.hpp"
#include "gearwright/catalogue/error_keys.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/catalogue/rating_keys.hpp"
#include "gearwright/catalogue/search_keys.hpp"
#include "gearwright/catalogue/spec_keys.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/tool/rack.hpp"

namespace gearwright {
namespace {

TEST(Keys, each_is_said_once_and_knows_its_neighbours) {
  std::size_t count = 0;
  for (const KeyTable* table : all_key_tables()) {
    std::set<std::string_view> names;
    for (const Key& key : table->keys) {
      ++count;
      const std::string where = fmt::format("{}.{}", table->name, key.key);
      EXPECT_TRUE(names.insert(key.key).second) << where << " stands there twice";
      EXPECT_FALSE(key.meaning.empty()) << where;
      EXPECT_FALSE(key.meaning.ends_with('.')) << where;
      for (const auto& others : {key.needs, key.excludes})
        for (const std::string_view other : others) EXPECT_TRUE(table->find(other)) << where;
      EXPECT_EQ(key.kind == KeyKind::table, !key.tables.empty()) << where;
      EXPECT_FALSE(key.kind == KeyKind::word && key.words.empty()) << where;
    }
  }
  EXPECT_GT(count, 150u);
}

TEST(Keys, a_place_takes_what_the_key_says) {
  for (const KeyTable* table : all_key_tables()) {
    for (const Key& key : table->keys) {
      if (!key.place || key.place.kind() == KeyKind::any)
        continue;  // the key is read elsewhere or is only checked
      // If the value may have several forms, its place stores a number.
      const KeyKind kind = key.kind == KeyKind::any ? KeyKind::number : key.kind;
      EXPECT_EQ(key.place.kind(), kind) << table->name << "." << key.key;
      EXPECT_TRUE(!key.place.is_angle() || key_unit(key.key) == "deg") << key.key;
      const bool table = key.kind == KeyKind::table;
      EXPECT_TRUE(!table || key.tables.size() == 1) << key.key;
      EXPECT_TRUE(!table || !key.list || !key.list->must.empty()) << key.key;
    }
  }
}

KeyValue value_of(const Key& key, const Json& v) {
  switch (key.kind) {
    case KeyKind::whole: return v.get<int>();
    case KeyKind::boolean: return v.get<bool>();
    case KeyKind::text: return v.get<std::string>();
    case KeyKind::word:
      return static_cast<int>(std::find(key.words.begin(), key.words.end(), v.get<std::string>()) -
                              key.words.begin());
    default: return v.get<double>();
  }
}

// If the default in the catalogue is a value, the struct has the same default.
template <class T>
void expect_defaults(const KeyTable& table, std::size_t at_least) {
  std::size_t seen = 0;
  for (const Key& key : table.keys) {
    const Json v = Json::parse(key.fallback, nullptr, false);
    if (!key.place.is_member() || key.list || v.is_discarded()) continue;
    T input{}, untouched{};
    key.place.put(input, value_of(key, v));
    // The default of a member that is empty by default is computed elsewhere.
    EXPECT_TRUE(key.place.same(untouched, input))
        << table.name << "." << key.key << " = " << key.fallback;
    EXPECT_TRUE(!v.is_number() || key.range.contains(v.get<double>())) << key.key;
    ++seen;
  }
  EXPECT_GE(seen, at_least) << table.name;
}

struct Target {
  std::vector<Angle> angles;
  std::optional<std::array<int, 2>> points;
  double mean = 0.0;
  std::optional<std::array<double, 2>> ends;
  std::vector<LoadProbeInput> probes;
  ContactInput contact;
};

TEST(Keys, the_type_of_a_member_decides_what_a_place_takes) {
  Target t;
  const KeyPlace angles(&Target::angles), points(&Target::points), probes(&Target::probes);
  EXPECT_TRUE(angles.kind() == KeyKind::number && angles.is_angle());
  EXPECT_EQ(points.kind(), KeyKind::whole);
  EXPECT_EQ(probes.kind(), KeyKind::table);
  angles.put(t, std::vector<double>{10.0, 20.0});
  EXPECT_EQ(t.angles, (std::vector{Angle::degrees(10), Angle::degrees(20)}));
  points.put(t, std::vector<double>{3.0, 4.0});
  EXPECT_EQ(t.points, (std::array{3, 4}));
  const auto both = KeyPlace::mean_and_ends<Target>(
      [](auto& x) -> auto& { return x.mean; }, [](auto& x) -> auto& { return x.ends; });
  both.put(t, std::vector<double>{1.0});
  EXPECT_TRUE(t.mean == 1.0 && !t.ends);
  both.put(t, std::vector<double>{1.0, 2.0});
  EXPECT_TRUE(t.mean == 1.5 && t.ends == (std::array{1.0, 2.0}));
  probes.part(t);
  probes.part(t).as<LoadProbeInput>().diameter = 5.0;
  EXPECT_TRUE(t.probes.size() == 2 && t.probes[1].diameter == 5.0);
  EXPECT_FALSE(t.contact.given);
  KeyPlace(&Target::contact).part(t);
  EXPECT_TRUE(t.contact.given);
  EXPECT_THROW(angles.put(t.contact, std::vector<double>{1.0}), ContractViolation);
}

struct ByNameOrTable {
  PerMember members;
  PerMesh meshes;
  std::vector<std::string> texts;
  std::array<std::string, 2> two;
  std::optional<double> mean;
  std::optional<DistributionSpec> range;
  Target inner;
};

TEST(Keys, a_place_takes_numbers_by_name_texts_and_two_ends) {
  ByNameOrTable t;
  const KeyPlace members(&ByNameOrTable::members), meshes(&ByNameOrTable::meshes);
  EXPECT_EQ(members.kind(), KeyKind::by_name);
  EXPECT_EQ(members.names(), set_member_names());
  members.put(t, 2.0);
  members.put(t, NamedNumbers{{"planet", 5.0}});
  EXPECT_EQ(t.members.of(SetMember::planet), 5.0);
  EXPECT_EQ(t.members.of(SetMember::sun), 2.0);
  meshes.put(t, std::vector<double>{1.0, 3.0});  // the mean of two limits
  meshes.put(t, NamedNumbers{{"planet_ring", 7.0}});
  EXPECT_EQ(t.meshes.of("planet_ring"), 7.0);
  EXPECT_EQ(t.meshes.of("sun_planet"), 2.0);
  KeyPlace(&ByNameOrTable::texts).put(t, std::vector<std::string>{"a"});
  KeyPlace(&ByNameOrTable::two).put(t, std::vector<std::string>{"b", "c"});
  EXPECT_TRUE(t.texts.front() == "a" && t.two[1] == "c");
  KeyPlace(&ByNameOrTable::mean).put(t, std::vector<double>{1.0, 2.0});
  EXPECT_EQ(t.mean, 1.5);
  const auto range = KeyPlace::ends_or_table<ByNameOrTable>(
      &DistributionSpec::range, [](ByNameOrTable & x) -> auto& { return x.range; });
  range.put(t, std::vector<double>{-1.0, 1.0});
  EXPECT_EQ(t.range->range, (std::array{-1.0, 1.0}));
  range.part(t).as<DistributionSpec>().cpk = 2.0;
  EXPECT_EQ(t.range->cpk, 2.0);
  KeyPlace(&Target::mean).inside(&ByNameOrTable::inner).put(t, 4.0);
  EXPECT_EQ(t.inner.mean, 4.0);
}

TEST(Keys, a_part_of_a_table_keeps_its_keys) {
  const KeyTable two = pair_keys().only({"speed_rpm", "mounting"});
  EXPECT_EQ(two.names(), (std::vector<std::string>{"speed_rpm", "mounting"}));
  const KeyTable rest = two.without({"speed_rpm"});
  EXPECT_EQ(rest.names(), std::vector<std::string>{"mounting"});
}

TEST(Keys, defaults_are_those_of_the_structs) {
  // The allowance is checked here, because its value may be a list and it therefore has no
  // KeyPlace.
  EXPECT_EQ(gear_keys().find("thickness_allowance_mm")->fallback, "0");
  EXPECT_EQ(GearInput{}.cylindrical.thickness_allowance, 0.0);
  expect_defaults<BasicInput>(basic_keys(), 1);
  expect_defaults<RootFilletSpec>(root_fillet_keys(), 1);
  expect_defaults<StraightRack>(straight_rack_keys(), 6);
  expect_defaults<DoubleArcRack>(double_arc_rack_keys(), 8);
  RackArc flank;
  rack_arc_keys().find("part")->place.put(flank, 1);
  EXPECT_EQ(rack_arc_keys().find("part")->fallback, "\"flank\"");
  EXPECT_TRUE(flank.cuts == RackArc{}.cuts && flank.working == RackArc{}.working);
  expect_defaults<PairInput>(pair_keys(), 2);
  expect_defaults<PlanetarySpec>(planetary_keys(), 3);
  expect_defaults<StageInput>(stage_keys(), 3);
  expect_defaults<GraphInput>(drive_keys(), 1);
  expect_defaults<ErrorsInput>(error_keys(), 8);
  expect_defaults<ContactInput>(contact_keys(), 5);
  expect_defaults<LoadInput>(load_keys(), 5);  // the default of `slices` depends on the face
  expect_defaults<LoadProbeInput>(load_probe_keys(), 1);
  expect_defaults<SearchProblem>(search_keys(), 6);
  expect_defaults<RatingTable>(rating_keys(), 5);
  expect_defaults<PinionMounting>(rating_mounting_keys(), 3);
}

TEST(Keys, the_limits_of_a_gear_are_its_own) {
  const auto refuses = [](const auto& set, double value) {
    CylindricalSpec spec = testing::plain_spec({.teeth = 20, .module = 2.0, .face_width = 2.0});
    set(spec, value);
    return check_limits(spec).has_value();
  };
  using Set = void (*)(CylindricalSpec&, double);
  for (const auto& [key, set] : {
           std::pair<const char*, Set>{
               "teeth", [](CylindricalSpec&s, double v) { s.teeth = static_cast<int>(v); }},
           {"normal_module_mm",
            [](CylindricalSpec&s, double v) { s.normal_module = s.face_width = v; }},
           {"normal_pressure_angle_deg",
            [](CylindricalSpec&s, double v) { s.normal_pressure_angle = Angle::degrees(v); }},
           {"helix_angle_deg",
            [](CylindricalSpec&s, double v) { s.helix_angle = Angle::degrees(v); }},
           {"profile_shift", [](CylindricalSpec&s, double v) { s.profile_shift = v; }},
       }) {
    const KeyRange& range = gear_keys().find(key)->range;
    for (const double end : {range.lo, range.hi}) {
      const double out = end == range.lo ? -1.0 : 1.0;
      const double step = std::string_view(key) == "teeth" ? 1.0 : 1e-6 * std::abs(end);
      EXPECT_FALSE(refuses(set, end)) << key << " = " << end;
      EXPECT_TRUE(refuses(set, end + out * step)) << key << " = " << end;
    }
  }
  EXPECT_TRUE(refuses([](CylindricalSpec& s, double) { s.teeth = 0; }, 0.0));
}

// A value that the table of a rack rejects is also rejected by the room `tool`, so no interface can
// exceed a limit.
template <class Rack, class Edge>
void expect_limits(const KeyTable& table, const Rack& good, const Edge& edge) {
  for (const Key& key : table.keys) {
    if (!key.place.is_member() || !key.range.limited() || key.place.is_angle()) continue;
    for (const double end : {key.range.lo, key.range.hi}) {
      if (!std::isfinite(end)) continue;
      Rack rack = good;
      const double step = 1e-6 * std::max(1.0, std::abs(end));
      key.place.put(rack, KeyValue(end == key.range.lo ? end - step : end + step));
      EXPECT_FALSE(edge(rack)) << table.name << "." << key.key << " beyond " << end;
    }
  }
}

TEST(Keys, the_limits_of_a_rack_are_its_own) {
  expect_limits(straight_rack_keys(), StraightRack{}, [](const StraightRack& r) {
    return static_cast<bool>(make_edge(r, 1.0, Angle::degrees(20)));
  });
  ArcRack f = default_arc_rack(ArcRack::Cutter::F);
  f.center_a = f.center_b = 0.1;
  expect_limits(arc_rack_keys(), f, [](const ArcRack& r) { return static_cast<bool>(arcs_of(r)); });
  expect_limits(double_arc_rack_keys(), DoubleArcRack{},
                [](const DoubleArcRack& r) { return static_cast<bool>(arcs_of(r)); });
}

TEST(Keys, ranges_in_words) {
  EXPECT_EQ(KeyRange::between(1, 60, ", usually 20").sentence(70),
            "must lie between 1 and 60, usually 20");
  EXPECT_EQ(KeyRange::inside(-90, 90).sentence(95),
            "must lie between -90 and 90, the ends excluded");
  EXPECT_EQ(KeyRange::between(0, 12).sentence(13), "must lie between 0 and 12");
  EXPECT_EQ(KeyRange::above(0, 90).sentence(0), "must be greater than 0 and at most 90");
  EXPECT_EQ(KeyRange::positive().sentence(0), "must be greater than 0");
  EXPECT_EQ(KeyRange::not_negative().sentence(-1), "must not be negative");
  const KeyRange teeth{.lo = -10, .hi = 10, .zero = false, .reason = "; internal gear"};
  EXPECT_EQ(teeth.sentence(0), "must not be 0; internal gear");
  EXPECT_EQ(teeth.sentence(11), "must lie between -10 and 10; internal gear");
}

TEST(Keys, units_and_members_stand_in_the_names) {
  EXPECT_EQ(key_unit("helix_angle_deg"), "deg");
  EXPECT_EQ(key_unit("normal_diametral_pitch_per_in"), "per_in");
  EXPECT_EQ(key_unit("power_kW"), "kW");
  EXPECT_EQ(key_unit("teeth"), "");
  using Members = std::vector<std::string>;
  EXPECT_EQ((Key{.key = "helix_angle_deg", .meaning = ""}).members(), Members{"helix_angle"});
  EXPECT_EQ((Key{.key = "lead_angle_deg", .meaning = "", .fields = {"helix_angle"}}).members(),
            Members{"helix_angle"});
  EXPECT_EQ(plain_words("height of `tool_addendum` [T3.4], in modules"),
            "height of tool_addendum, in modules");
}

TEST(Keys, the_eight_errors_and_seven_modifications_have_their_derivatives) {
  std::set<ErrorKind> kinds;
  for (const ErrorEntry& e : error_entries()) {
    if (e.kind) kinds.insert(*e.kind);
  }
  EXPECT_EQ(kinds.size(), kErrorKinds.size());
  for (std::size_t i = 0; i < kModifications.size(); ++i) {
    const ModificationEntry& m = modification_entries()[i];
    EXPECT_EQ(static_cast<std::size_t>(m.kind), i) << m.name;
    EXPECT_NE(m.relief == nullptr, m.alone == nullptr) << m.name;
  }
  Gear gear{};
  gear.reference_diameter = 20.0;
  gear.spec.face_width = 5.0;
  for (const ErrorEntry& e : error_entries()) {
    ContactErrors errors;
    e.set(errors, {&gear, &gear}, 2.0);
    const Angle turned =
        errors.crossing + errors.intersecting + errors.cutter_lead[0] + errors.cutter_lead[1];
    const double sum = errors.center_distance + errors.axial + turned.rad() +
                       50.0 * (errors.helix_twist[0] + errors.helix_twist[1]);
    EXPECT_DOUBLE_EQ(sum, 2.0 * e.si()) << e.key;
  }
}

TEST(Keys, a_word_is_a_slip_of_another_one_or_a_part_of_it) {
  const std::vector<std::string> steels{"16MnCr5", "18CrNiMo7-6", "C45N"};
  const auto starts = [&](const char* word) { return word_hint(word, steels).substr(0, 25); };
  EXPECT_EQ(starts("16mncr5"), "did you mean 16MnCr5? Kno");
  EXPECT_EQ(starts("18CrNiMo7"), "did you mean 18CrNiMo7-6?");
  EXPECT_EQ(starts("C45"), "did you mean C45N? Known ");
  for (const char* word : {"POM", "PA66", "brass", "N", ""})
    EXPECT_EQ(word_hint(word, steels), "known are 16MnCr5, 18CrNiMo7-6, C45N") << word;
  EXPECT_EQ(word_hint("weight", {"ratio", "mass"}, "mass"),
            "did you mean mass? Known are ratio, mass");
}

TEST(Keys, exchanged_letters_are_one_error) {
  EXPECT_EQ(edit_distance("gaer", "gear"), 1U);
  EXPECT_EQ(edit_distance("ratoi", "ratio"), 1U);
  EXPECT_EQ(edit_distance("ca", "abc"), 3U);  // no letter is changed twice
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("abc", ""), 3U);
}

TEST(Keys, the_rule_of_a_word_suggests_the_nearest_one) {
  EXPECT_EQ(one_of_rule("lefft", {"right", "left"}),
            "must be one of \"right\", \"left\"; did you mean left?");
  EXPECT_EQ(one_of_rule("up", {"right", "left"}), "must be one of \"right\", \"left\"");
}

}  // namespace
}  // namespace gearwright
