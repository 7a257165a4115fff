#include "gearwright/spec/read_gear.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "gearwright/base/number_text.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/spec/inherit.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

namespace {

void read_spans(TableReader& t, IdentifyProblem& p) {
  const Json* node = t.any("span_mm");
  if (!node) return;
  if (!node->is_object())
    t.fail("span_mm",
           "must be a table with one reading for each number of teeth, for example { 3 = 19.751 }");
  for (const auto& [key, value] : node->items()) {
    const std::int64_t k = whole_number(key).value_or(0);
    if (k < 1 || k > 100000)
      t.fail("span_mm", "\"" + printable(key, 20) +
                            "\" is not a number of teeth; write each reading after its number of "
                            "teeth, for example { 3 = 19.751 }");
    const KeyRange range = KeyRange::above(0.0, kMaxInput);
    const double span = value.is_number() ? value.get<double>() : 0.0;
    if (!range.contains(span))
      t.fail("span_mm", "the span over " + key + " teeth " + range.sentence(span));
    p.spans.push_back({static_cast<int>(k), span});
  }
  std::sort(p.spans.begin(), p.spans.end(),
            [](const SpanReading& a, const SpanReading& b) { return a.teeth < b.teeth; });
}

// Adds the data of the mating gear if the readings do not contain them.
void add_mating_gear(const Json& tree, int mate, Json& readings) {
  const std::string name = gear_field(mate);
  if (!tree.contains(name) || !tree[name].is_object() || is_rack(tree[name])) return;
  TableReader gear(gear_keys(), tree[name], name);
  gear.refuse_unknown();
  if (readings.contains("mating_teeth") || !gear.has("teeth")) return;
  if (!readings.contains("center_distance_mm")) {
    const Json pair = tree.value("pair", Json::object());
    const auto distance = TableReader(pair_keys(), pair, "pair").number("center_distance_mm");
    if (!distance) return;
    readings["center_distance_mm"] = *distance;
  }
  GearInput mating;
  gear.read(*gear_keys().find("teeth"), mating);
  readings["mating_teeth"] = mating.cylindrical.teeth;
}

// Reads the keys of an unknown gear that identify() does not compute. They are checked here and
// stay in the spec of every candidate. identify() uses a given profile shift, thickness allowance
// or rack as a known value.
void read_kept_keys(const Json& gear, const std::string& path, IdentifyProblem& p) {
  TableReader t(gear_keys(), gear, path);
  t.refuse_unknown();
  for (const char* key :
       {"transverse_pressure_angle_deg", "lead_angle_deg", "hand", "profile_shift_pair", "form"})
    t.refuse(key,
             "does not apply to an unknown gear; if the angles are known, give "
             "normal_pressure_angle_deg and helix_angle_deg");
  if (gear.contains("rack")) {
    p.rack = read_straight_rack(t);
    p.normal_pressure_angle = rack_angle(t, p.normal_pressure_angle);
  }
  GearInput kept;
  for (const Key& key : gear_keys().keys) {
    const std::string name(key.key);
    if (key.place && gear.contains(name) && !unknown_gear_keys().find(name)) t.read(key, kept);
  }
  p.profile_shift = t.number("profile_shift");
  if (gear.contains("thickness_allowance_mm"))
    p.thickness_allowance = kept.cylindrical.thickness_allowance;
  if (p.profile_shift && p.thickness_allowance)
    t.fail("thickness_allowance_mm",
           "cannot be combined with profile_shift for an unknown gear: if one of these two keys is "
           "given, the other is computed from it and the readings; leave out one of them");
}

}  // namespace

bool has_module(const Json& gear) {
  std::vector<std::string> known = gear_keys().ways("normal_module_mm");
  known.insert(known.end(), {"basic", "cut_by"});
  return has_any(gear, known);
}

bool is_unknown_gear(const Json& gear) {
  return gear.is_object() && gear.contains("measured") && !has_module(gear);
}

std::shared_ptr<const IdentifyProblem> read_measured(const Json& tree, int which) {
  const std::string path = gear_field(which);
  const Json gear = tree.value(path, Json());
  if (!gear.is_object() || !gear.contains("measured")) return nullptr;
  Json readings = gear["measured"];
  if (!readings.is_object())
    throw SpecError{
        {path + ".measured", shown(readings), "must be a table, [" + path + ".measured]"}};
  IdentifyProblem p;
  // The keys that identify() needs. The other keys of a known gear are not checked here.
  const bool unknown = is_unknown_gear(gear);
  Json known = Json::object();
  for (const Key& key : unknown_gear_keys().keys) {
    const std::string name(key.key);
    if (gear.contains(name)) known[name] = gear[name];
  }
  if (unknown) add_mating_gear(tree, 3 - which, readings);
  TableReader outside(unknown_gear_keys(), known, path);
  GearInput like;
  outside.read(like);
  p.teeth = like.cylindrical.teeth;
  if (outside.given("normal_pressure_angle_deg"))
    p.normal_pressure_angle = like.cylindrical.normal_pressure_angle;
  if (const auto beta = outside.number("helix_angle_deg")) p.helix_angle = Angle::degrees(*beta);
  outside.table("measured");
  if (unknown) read_kept_keys(gear, path, p);
  outside.finish();
  TableReader t(measured_keys(), readings, path + ".measured");
  read_spans(t, p);
  t.read_whole(p);
  return std::make_shared<const IdentifyProblem>(std::move(p));
}

}  // namespace gearwright
