#include "gearwright/job/corrected_spec.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "gearwright/gear/gear.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {

namespace {

const char* needs(const WorkshopCorrection& c) {
  if (c.is(CutterSetting::tool_setting))
    return "is a setting of the circular-arc rack F, but this rack cuts neither gear";
  if (c.is(CutterSetting::cutter_lead)) return "needs a helical gear cut by a rack";
  if (*c.modification() == Modification::end_relief)
    return "needs the length of the relief, end_relief_length_mm, in the modifications of the "
           "gear; the amount of the relief may be 0";
  return "needs a relief in the modifications of the gear; give an amount greater than 0, for "
         "which the start is computed, or give a start, for example tip_relief_start_mm, with the "
         "amount 0";
}

}  // namespace

Result<std::vector<WorkshopCorrection>> corrections_of(const ContactSetup& setup,
                                                       const std::vector<std::size_t>& places,
                                                       const std::string& field) {
  if (places.empty()) return usual_corrections(setup);
  std::vector<WorkshopCorrection> list;
  for (const std::size_t place : places) {
    const WorkshopCorrection& c = correction_entries()[place].correction;
    if (!can_take(setup, c)) return Error{field, std::string(entry_of(c).key), needs(c)};
    list.push_back(c);
  }
  return list;
}

std::string spec_key(const ContactSetup& setup, const WorkshopCorrection& c, bool gear2_drives) {
  if (c.is(CutterSetting::tool_setting))
    return fmt::format("gear{}.rack.center_b", *setup.convex_gear());
  if (c.is(CutterSetting::cutter_lead)) return fmt::format("errors.{}", entry_of(c).key);
  const bool left = setup.gear(c.gear).left_flank_works(gear2_drives);
  return fmt::format("gear{}.modifications.{}{}", c.gear,
                     !c.slope() ? ""
                     : left     ? "left_"
                                : "right_",
                     entry_of(c).own_key());
}

bool at_bound(const Correction& range, double value) {
  const double reach = 0.02 * range.step;
  return value != 0.0 && (value - range.lo < reach || range.hi - value < reach);
}

FoundCorrection found_correction(const WorkshopCorrection& correction, double value,
                                 std::string spec_key, bool at_bound) {
  const CorrectionEntry& c = entry_of(correction);
  return {std::string(c.key),   std::string(c.unit()),
          std::string(c.words), value,
          std::move(spec_key),  at_bound};
}

Json plain_first(const Json& tree) {
  Json ordered = Json::object();
  for (const bool tables : {false, true})
    for (const auto& [key, value] : tree.items())
      if (value.is_object() == tables) ordered[key] = value;
  return ordered;
}

Json corrected_spec(const SolvedJob& job, const ContactSetup& setup,
                    const std::vector<WorkshopCorrection>& which, const std::vector<double>& v,
                    bool gear2_drives) {
  Json tree = job.spec.tree->tables;
  const auto add = [](Json& table, const std::string& key, double value) {
    // In binary arithmetic, a sum of decimals has additional digits. Rounding removes these digits.
    constexpr double kDigits = 1e9;
    const double sum = (table.contains(key) ? table[key].get<double>() : 0.0) + value;
    table[key] = std::round(sum * kDigits) / kDigits;
  };
  for (std::size_t k = 0; k < which.size(); ++k) {
    const WorkshopCorrection& c = which[k];
    if (v[k] == 0.0) continue;
    if (c.is(CutterSetting::tool_setting)) {
      const int gear = *setup.convex_gear();
      Json& rack = tree[gear_field(gear)]["rack"];
      const auto& arc = std::get<ArcRack>(setup.gear(gear).spec.rack);
      rack["center_b"] = arc.center_b + v[k] / setup.gear(gear).spec.normal_module;
      rack.erase("pressure_angle_deg");  // this key would contradict the new setting
    } else if (c.is(CutterSetting::cutter_lead)) {
      add(tree["errors"], std::string(entry_of(c).key),
          v[k]);  // the correction and the error have the same key in [errors]
    } else {
      const std::string name(entry_of(c).own_key());
      const bool slope = c.slope();
      Json& table = tree[gear_field(c.gear)]["modifications"];
      const std::string path = spec_key(setup, c, gear2_drives);
      const std::string own = path.substr(path.rfind('.') + 1);
      // If the spec gives one slope for both flanks, the slope of this flank becomes the given
      // slope plus the correction.
      if (slope && !table.contains(own) && table.contains(name)) table[own] = table[name];
      add(table, own, v[k]);
      // A correction for both flanks is also added to an amount that is given for a single flank.
      for (const char* side : {"left_", "right_"})
        if (!slope && table.contains(side + name)) add(table, side + name, v[k]);
      // If both flanks have separate amounts, the common amount has no effect and is removed.
      if (table.contains("left_" + name) && table.contains("right_" + name)) table.erase(name);
    }
  }
  return plain_first(tree);
}

}  // namespace gearwright
