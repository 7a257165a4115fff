#include "gearwright/job/proposal_spec.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/modification_keys.hpp"
#include "gearwright/gear/gear_field.hpp"

namespace gearwright {

namespace {

// Amounts are whole µm and starts have three decimals of a millimetre. Rounding removes the digits
// that the conversion adds.
double decimals(double x, double steps) { return std::round(x * steps) / steps; }
double um(double mm) { return decimals(mm * kUmPerMm, 1.0); }
double diameter(double mm) { return decimals(mm, kUmPerMm); }

bool begins_with_any(std::string_view key, const std::vector<std::string_view>& names) {
  for (const std::string_view side : kFlankSides)
    if (key.starts_with(side)) key.remove_prefix(side.size());
  for (const std::string_view name : names)
    if (key.starts_with(name)) return true;
  return false;
}

void erase(Json& table, const std::vector<std::string_view>& names) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : table.items())
    if (begins_with_any(key, names)) keys.push_back(key);
  for (const std::string& key : keys) table.erase(key);
}

void put(Json& table, const char* amount_key, const std::optional<double>& amount,
         const char* start_key = "", const std::optional<double>& start = {}) {
  if (amount.value_or(0.0) == 0.0) return;
  table[amount_key] = um(*amount);
  if (start) table[start_key] = diameter(*start);
}

}  // namespace

Json with_proposal(const Json& tree, const Proposal& p, bool gear2_drives) {
  Json made = tree;
  const bool profile = p.profile != ProposedProfile::as_given;
  for (const int which : {1, 2}) {
    const ProposedGear& g = p.gears[static_cast<std::size_t>(which - 1)];
    Json& gear = made[gear_field(which)];
    Json table = gear.value("modifications", Json::object());
    if (profile) erase(table, {"tip_relief", "root_relief", "profile_", "topography"});
    if (p.lead) erase(table, {"lead_", "end_relief", "topography"});
    put(table, "tip_relief_um", g.tip_relief, "tip_relief_start_mm", g.tip_start);
    put(table, "root_relief_um", g.root_relief, "root_relief_start_mm", g.root_start);
    put(table, "lead_crowning_um", g.lead_crowning);
    put(table, gear2_drives ? "left_lead_slope_um" : "right_lead_slope_um", g.lead_slope);
    gear.erase("modifications");
    if (!table.empty()) gear["modifications"] = std::move(table);
  }
  return made;
}

}  // namespace gearwright
