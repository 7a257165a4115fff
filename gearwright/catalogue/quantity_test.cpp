// The laws of the catalogue of results.
//
//   (1) a key occurs once in a record, and if it ends with a unit, the unit is the right one
//   (2) the words are a term with a small first letter; words and meaning have no full stop
//   (3) a value has the declared type and lengths; it is never null if it is always present
//   (4) all interfaces give the value of the getter; if the JSON value is null, none shows a number
//   (5) a key that occurs in several tables with the same words and the same symbol is a term
//   (6) the type of a getter shows the lengths of lists and whether a value can be null
#include "gearwright/catalogue/quantity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "gearwright/catalogue/compensate_quantities.hpp"
#include "gearwright/catalogue/contact_quantities.hpp"
#include "gearwright/catalogue/file_quantities.hpp"
#include "gearwright/catalogue/fit_quantities.hpp"
#include "gearwright/catalogue/gear_quantities.hpp"
#include "gearwright/catalogue/load_quantities.hpp"
#include "gearwright/catalogue/rating_quantities.hpp"
#include "gearwright/catalogue/search_quantities.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {
namespace {

TEST(Catalogue, EveryKeyStandsOnceAndEndsWithItsUnit) {
  const auto tables = result_tables();
  EXPECT_GT(tables.size(), 100u);
  for (const QuantityTable* t : tables) {
    std::set<std::string> keys;
    for (const QuantityInfo* s : t->list) {
      EXPECT_TRUE(keys.insert(s->key).second) << t->name << ": " << s->key;
      for (const Unit u :
           {Unit::mm, Unit::um, Unit::deg, Unit::arcsec, Unit::per_mm, Unit::mm_per_rad}) {
        const bool ends = s->key.ends_with(unit_suffix(u));
        // "_per_mm" is not a length, and "_N_per_mm" is not a curvature.
        const bool longer = (u == Unit::mm && s->key.ends_with("_per_mm")) ||
                            s->key.ends_with("_N_per_mm") || s->key.ends_with("_per_N_mm");
        if (ends && !longer && s->type != Type::record) {
          EXPECT_EQ(s->unit, u) << t->name << ": " << s->key;
        }
      }
    }
  }
}

TEST(Catalogue, SharedWordsAreTerms) {
  EXPECT_TRUE(std::is_sorted(terms().begin(), terms().end(), [](const Term& a, const Term& b) {
    return std::string_view(a.key) < b.key;
  }));
  std::map<std::pair<Type, std::array<std::string, 3>>, std::set<std::string>> tables;
  for (const QuantityTable* t : result_tables())
    for (const QuantityInfo* s : t->list)
      // The tables of stiffness are left out, because one function fills both of them.
      if (s->type != Type::record && s->type != Type::text && s->type != Type::map &&
          !t->name.ends_with("stiffness"))
        tables[{s->type, {s->key, s->words, s->symbol}}].insert(t->name);
  std::size_t shared = 0;
  for (const auto& [said, in] : tables) {
    if (in.size() < 2) continue;
    ++shared;
    const std::string& key = said.second[0];
    const auto is_this = [&](const Term& term) { return term.key == key; };
    EXPECT_TRUE(std::any_of(terms().begin(), terms().end(), is_this))
        << key << " is worded in " << in.size() << " tables: " << *in.begin();
  }
  EXPECT_GT(shared, 30u);
}

TEST(Catalogue, WordsAreTerms) {
  for (const QuantityTable* t : result_tables()) {
    for (const QuantityInfo* s : t->list) {
      ASSERT_FALSE(s->words.empty()) << t->name << ": " << s->key;
      if (!(s->doors & kPeople) || s->type == Type::record) continue;
      EXPECT_FALSE(s->words[0] >= 'A' && s->words[0] <= 'Z') << s->words;
      EXPECT_NE(s->words.back(), '.') << s->words;
      if (!s->meaning.empty()) {
        EXPECT_NE(s->meaning.back(), '.') << s->meaning;
      }
    }
  }
}

// Tips have this alteration only with `shorten_tips`, so the words must not state that it is
// applied.
TEST(Catalogue, TheTipAlterationOfAPairIsThatForFullClearance) {
  const QuantityInfo* info = pair_quantities().table().find("tip_shortening_mm");
  ASSERT_NE(info, nullptr);
  EXPECT_EQ(info->words, "tip alteration for full tip clearance");
  EXPECT_NE(info->meaning.find("only with `shorten_tips`"), std::string::npos);
}

// Describes the difference between a value and its declaration. The text is empty if they agree.
std::string fault(const QuantityInfo& s, const Value& v, std::size_t depth = 0);

std::string fault_in(const ValueRecord& record) {
  for (const Member& m : record) {
    if (const std::string f = fault(*m.info, m.value); !f.empty()) return m.info->key + ": " + f;
  }
  return {};
}

std::string fault(const QuantityInfo& s, const Value& v, std::size_t depth) {
  if (v.nothing()) return s.always && depth == 0 ? "is null" : "";
  if (depth < s.list.size()) {
    const ValueList* list = v.list();
    if (!list) return "is no list";
    if (s.list[depth] > 0 && list->size() != static_cast<std::size_t>(s.list[depth]))
      return "has " + std::to_string(list->size()) + " values";
    for (const Value& inner : *list) {
      if (const std::string f = fault(s, inner, depth + 1); !f.empty()) return f;
    }
    return {};
  }
  const auto& variant = v.variant();
  switch (s.type) {
    case Type::number: {
      const auto* x = std::get_if<double>(&variant);
      if (!x) return "is no number";
      return s.always && depth == 0 && !std::isfinite(*x) ? "is not finite" : "";
    }
    case Type::whole:
    case Type::index: return std::holds_alternative<long long>(variant) ? "" : "is not whole";
    case Type::flag: return std::holds_alternative<bool>(variant) ? "" : "is no flag";
    case Type::text: return std::holds_alternative<std::string>(variant) ? "" : "is no text";
    case Type::word: {
      const auto* word = std::get_if<std::string>(&variant);
      if (!word) return "is no word";
      const bool known =
          s.one_of.empty() || std::count(s.one_of.begin(), s.one_of.end(), *word) == 1;
      return known ? "" : "is " + *word;
    }
    case Type::record: return v.record() ? fault_in(*v.record()) : "is no record";
    case Type::map: return "";
  }
  return "has no type";
}

SolvedJob solved(const std::string& text) {
  const auto spec = read_spec(text, SpecFormat::toml);
  EXPECT_TRUE(spec) << (spec ? "" : spec.error().message());
  auto job = solve(*spec, Scope::everything);
  EXPECT_TRUE(job) << (job ? "" : job.error().message());
  return std::move(job).take();
}

const char* const kSpecs[] = {
    "[gear1]\nteeth = 17\nnormal_module_mm = 2.5\nhelix_angle_deg = 15\nprofile_shift = 0.3\n"
    "[gear2]\nteeth = 43\nnormal_module_mm = 2.5\nhelix_angle_deg = -15\n"
    "[pair]\nfriction_coefficient = 0.05\n",
    "[gear1]\nteeth = 9\nnormal_module_mm = 2\n[gear2]\nteeth = 30\nnormal_module_mm = 2\n",
    "[gear1]\nteeth = 20\nnormal_module_mm = 2\n[gear2]\nteeth = -60\nnormal_module_mm = 2\n",
    "[gear1]\nteeth = 16\nnormal_module_mm = 2\nhelix_angle_deg = 45\n"
    "[gear2]\nteeth = 31\nnormal_module_mm = 2\nhelix_angle_deg = 45\n"
    "[pair]\nshaft_angle_deg = 90\n",
    ("[gear1]\nteeth = 2\nnormal_module_mm = 2\nhelix_angle_deg = 30\nface_width_mm = 30\n"
     "root_fillet.kind = \"circular\"\nroot_fillet.offset_mm = 0.02\n")};

TEST(Catalogue, ValuesAreWhatIsSaidOfThem) {
  for (const char* text : kSpecs) {
    const SolvedJob job = solved(text);
    for (const Gear& g : job.gears) EXPECT_EQ(fault_in(gear_quantities().of(g)), "") << text;
    if (job.pair) {
      EXPECT_EQ(fault_in(pair_quantities().of(*job.pair)), "") << text;
    }
    EXPECT_EQ(fault_in({{warning_quantities().table().list[0], Value("code")}}), "");
  }
}

// If the tip circle lies inside the base circle, the gear has no involute, and no interface shows a
// tip form diameter.
TEST(Catalogue, WhatIsNotThereIsADashAtEveryDoor) {
  const SolvedJob job =
      solved("[gear1]\nteeth = 10\nnormal_module_mm = 2\ntip_diameter_mm = 17.5\n");
  const ValueRecord record = gear_quantities().of(job.gears[0]);
  const QuantityInfo* info = gear_quantities().table().find("tip_form_diameter_mm");
  for (const Member& m : record)
    if (m.info == info) {
      EXPECT_TRUE(m.value.nothing());
    }
  for (const Doors door : {kListing, kPage}) {
    int rows = 0;
    for (const TextGroup& g :
         text_groups(gear_quantities().table(), {record}, door, UnitSystem::mm, "-")) {
      for (const TextRow& row : g.rows) {
        if (row.info != info) continue;
        ++rows;
        EXPECT_EQ(row.texts, std::vector<std::string>{"-"});
      }
    }
    EXPECT_EQ(rows, 1);
  }
}

struct Sample {
  double number = 1.0;
  std::optional<double> maybe{};
  std::array<double, 2> two{};
  std::array<std::optional<double>, 2> two_maybe{};
  std::vector<Vec3> points{};
  std::optional<Vec3> point{};
  std::string word{};
  Value value{};
};

const Quantities<Sample>& inner_quantities() {
  return define("inner", [](Quantities<Sample>& q) {
    q.number("a", "a", "", "", &Sample::number);
    q.number("b", "b", "", "", &Sample::maybe);
    q.number("c", "c", "", "", &Sample::two);
    q.number("d", "d", "", "", &Sample::two_maybe);
    q.number("e", "e", "", "", &Sample::points);
    q.number("f", "f", "", "", &Sample::point);
    q.word("g", "g", "", &Sample::word);
    q.number("h", "h", "", "", &Sample::value);
    q.number("i", "i", "", "", &Sample::number).or_null();
    q.part(+[](const Sample& s) { return &s; }).number("j", "j", "", "", &Sample::two);
  });
}

const Quantities<Sample>& sample_quantities() {
  return define("sample", [](Quantities<Sample>& q) {
    q.record<inner_quantities>("one", "");
    q.record<inner_quantities>("all", "", [](const Sample& s) { return std::vector{s}; });
    q.record<inner_quantities>("maybe", "", [](const Sample& s) { return std::optional(s); });
    q.record<inner_quantities>("pointer", "", [](const Sample& s) { return &s; });
    q.record<inner_quantities>("finished", "", [](const Sample&) { return Value(); });
  });
}

// (6) `always` and `list` of each entry.
TEST(Catalogue, GettersShowTheShapeOfTheirValues) {
  using List = std::vector<int>;
  const auto shapes = [](const QuantityTable& table) {
    std::vector<std::pair<bool, List>> all;
    for (const QuantityInfo* info : table.list) all.emplace_back(info->always, info->list);
    return all;
  };
  const std::vector<std::pair<bool, List>> plain{
      {true, {}},   {false, {}}, {true, {2}}, {false, {2}}, {true, {0, 3}},
      {false, {3}}, {true, {}},  {false, {}}, {false, {}},  {false, {2}}};
  EXPECT_EQ(shapes(inner_quantities().table()), plain);
  const std::vector<std::pair<bool, List>> records{
      {true, {}}, {true, {0}}, {false, {}}, {false, {}}, {false, {}}};
  EXPECT_EQ(shapes(sample_quantities().table()), records);
}

TEST(Catalogue, TextsOfValues) {
  QuantityInfo length{.key = "a_mm", .words = "a", .symbol = "", .unit = Unit::mm};
  EXPECT_EQ(text_of(length, 1.23456), "1.2346");
  EXPECT_EQ(text_of(length, -1e-9), "0.0000");
  EXPECT_EQ(text_of(length, Value()), "–");
  EXPECT_EQ(text_of(length, Value(), "-"), "-");
  length.nothing = "self-locking";
  EXPECT_EQ(text_of(length, Value()), "self-locking");
  length.list = {2};
  EXPECT_EQ(text_of(length, std::array{1.0, 2.0}), "1.0000, 2.0000");
  length.two = Two::ends;
  EXPECT_EQ(text_of(length, std::array{1.0, 2.0}), "1.0000 … 2.0000");
  const QuantityInfo share{.key = "s", .words = "s", .symbol = "", .unit = Unit::percent};
  EXPECT_EQ(text_of(share, 0.5), "50.000");
}

}  // namespace
}  // namespace gearwright
