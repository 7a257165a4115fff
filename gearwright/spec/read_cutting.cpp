#include "gearwright/spec/read_cutting.hpp"

#include <nlohmann/json.hpp>

#include "gearwright/spec/read_gear.hpp"

namespace gearwright {

namespace {

// Numbers that a gear, its cutter and its mating gear share. The table of a cutter may omit them.
Json with_shared_keys(const Json& cutter, const Json& gear, const Json* mate) {
  Json whole = cutter;
  for (const char* key_of_both : {"normal_module_mm", "normal_pressure_angle_deg"}) {
    const std::vector<std::string> keys = gear_keys().ways(key_of_both);
    if (has_any(cutter, keys)) continue;
    const Json* from = has_any(gear, keys) ? &gear : mate;
    for (const std::string& key : keys)
      if (from && from->contains(key)) whole[key] = (*from)[key];
  }
  static const std::vector<std::string> kHelix{"helix_angle_deg", "lead_angle_deg", "hand"};
  if (has_any(cutter, kHelix)) return whole;
  if (gear.contains("helix_angle_deg") && gear["helix_angle_deg"].is_number()) {
    const bool ring = gear.contains("teeth") && gear["teeth"].is_number() && gear["teeth"] < 0;
    whole["helix_angle_deg"] = (ring ? 1.0 : -1.0) * gear["helix_angle_deg"].get<double>();
  } else if (!has_any(gear, kHelix) && mate) {  // the cutter replaces the mating gear
    for (const std::string& key : kHelix) {
      if (mate->contains(key)) whole[key] = (*mate)[key];
    }
  }
  return whole;
}

// A cutter reaches deep enough for the clearance of the teeth.
constexpr double kCutterAddendum = 1.25;

}  // namespace

void read_cut_by(TableReader& gear, const Json& node, const Json* mate, GearInput& g) {
  const auto total = gear.number("profile_shift_pair");
  const Json* by = gear.any("cut_by");
  if (!by) {
    if (total) gear.fail("profile_shift_pair", "belongs to a gear with cut_by");
    return;
  }
  CutByInput cut;
  cut.profile_shift_pair = total;
  if (by->is_string()) {
    const auto name = by->get<std::string>();
    if (name != "gear1" && name != "gear2")
      gear.fail("cut_by", "must be \"gear1\", \"gear2\" or a table with a cutter's numbers");
    cut.gear = name == "gear1" ? 1 : 2;
  } else if (by->is_object()) {
    const std::string path = gear.name("cut_by");
    for (const auto& [key, why] :
         {std::pair{"cut_by", "the cutter itself is cut by a rack; leave this out"},
          std::pair{"profile_shift_pair",
                    "belongs into the table of the gear that is cut, not "
                    "into cut_by"},
          std::pair{"modifications",
                    "a cutter has no flank modifications; write those of the gear into the gear's "
                    "own table"}}) {
      if (by->contains(key)) gear.fail(std::string("cut_by.") + key, why);
    }
    GearInput cutter = read_gear(cutter_keys(), with_shared_keys(*by, node, mate), path);
    if (cutter.cylindrical.teeth < 0)
      gear.fail("cut_by.teeth", "must be positive: an internal gear cannot be a pinion cutter");
    if (!by->contains("rack")) cutter.cylindrical.straight_rack().addendum = kCutterAddendum;
    if (cutter.tip_clearance || cutter.tip_clearance_by_rule) {
      gear.fail("cut_by.tip_fillet",
                "a cutter has no mating gear that could determine it; give corner_radius_mm, "
                "radius_mm or l_mm");
    }
    cut.cutter = std::make_shared<GearInput>(std::move(cutter));
  } else {
    gear.fail("cut_by", "must be \"gear1\", \"gear2\" or a table with a cutter's numbers");
  }
  for (const char* key : {"rack", "root_fillet", "tip_fillet", "basic", "thickness_allowance_mm"}) {
    if (gear.has(key)) {
      gear.fail(key,
                "cannot be combined with cut_by, because the cutter and the generating centre "
                "distance determine the tooth");
    }
  }
  if (total && g.profile_shift) {
    gear.fail("profile_shift_pair",
              "cannot be combined with profile_shift; both determine the depth of the cutter; "
              "leave one of them out");
  }
  g.cut_by = std::move(cut);
}

}  // namespace gearwright
