#include "gearwright/job/compensate_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "gearwright/job/fixed_text.hpp"

namespace gearwright {

namespace {

constexpr double kDeg = 180 / std::numbers::pi;
constexpr double kArcsec = 3600 * kDeg;

std::string unit_of(const std::string& key) {
  const std::string unit = key.substr(key.rfind('_') + 1);
  return unit == "um" ? "µm" : unit == "deg" ? "°" : unit;
}

Json optional_deg(const std::optional<double>& rad) {
  return rad ? Json(*rad * kDeg) : Json(nullptr);
}

Json score_json(const ContactScore& s) {
  return {{"peak_to_peak_arcsec",
           std::isfinite(s.peak_to_peak) ? Json(s.peak_to_peak * kArcsec) : Json(nullptr)},
          {"contact_along_face", s.along_face},
          {"contact_along_profile", s.along_profile},
          {"contact_lost", s.lost}};
}

std::string degrees(const std::optional<double>& rad) {
  return rad ? fixed_text(*rad * kDeg, 6) + " °" : "-";
}

std::string percent(double v) { return fixed_text(100 * v, 1) + " %"; }

}  // namespace

Json compensate_json(const SolvedJob& job, const CompensateAnswer& a) {
  Json corrections = Json::array();
  for (std::size_t i = 0; i < a.corrections.size(); ++i) {
    const std::string key = kCorrections[a.corrections[i]].key;
    corrections.push_back(
        {{"key", key}, {"value", a.result.value[i]}, {"unit", key.substr(key.rfind('_') + 1)}});
  }
  Json scenarios = Json::array();
  for (std::size_t i = 0; i < a.scenarios.size(); ++i) {
    scenarios.push_back({{"errors", a.scenarios[i]},
                         {"before", score_json(a.result.each_before[i])},
                         {"after", score_json(a.result.each_after[i])}});
  }
  Json c;
  c["corrections"] = std::move(corrections);
  c["before"] = score_json(a.result.before);
  c["after"] = score_json(a.result.after);
  c["scenarios"] = std::move(scenarios);
  c["tool_setting"] = nullptr;
  if (a.setting) {
    c["tool_setting"] = {{"exact_mm", a.setting->exact},
                         {"first_order_mm", a.setting->first_order},
                         {"pressure_angle_deg",
                          {{"nominal", optional_deg(a.setting->angle_nominal)},
                           {"displaced", optional_deg(a.setting->angle_displaced)},
                           {"exact", optional_deg(a.setting->angle_exact)},
                           {"first_order", optional_deg(a.setting->angle_first_order)}}},
                         {"tooth_thickness_change_mm", a.setting->thickness_change},
                         {"backlash_change_mm", a.setting->backlash_change}};
  }
  c["lead"] = nullptr;
  if (a.lead) {
    c["lead"] = {{"slope", a.lead->slope},
                 {"cutter_lead1_deg", optional_deg(a.lead->exact[0])},
                 {"cutter_lead2_deg", optional_deg(a.lead->exact[1])},
                 {"first_order1_deg", optional_deg(a.lead->first_order)}};
  }
  c["spec"] = parse_json(a.corrected);
  Json j;
  if (!job.spec.title.empty()) j["title"] = job.spec.title;
  j["compensate"] = std::move(c);
  j["warnings"] = warnings_json(job.warnings);
  return j;
}

std::string compensate_listing(const SolvedJob& job, const CompensateAnswer& a) {
  std::string out;
  if (!job.spec.title.empty()) out += job.spec.title + "\n";
  const auto head = [&](const char* text) { out += fmt::format("\n{}\n", text); };
  const auto row = [&](const std::string& what, const std::string& value) {
    out += fmt::format("  {:<44}{}\n", what, value);
  };
  if (a.setting) {
    head("Setting of rack F that brings the contact back");
    row("Change of b_F, exact", fixed_text(a.setting->exact, 6) + " mm");
    row("  to the first order, as the paper has it", fixed_text(a.setting->first_order, 6) + " mm");
    row("Pressure angle as drawn", degrees(a.setting->angle_nominal));
    row("  with the change of centre distance", degrees(a.setting->angle_displaced));
    row("  and the exact setting", degrees(a.setting->angle_exact));
    row("  and the first-order setting", degrees(a.setting->angle_first_order));
    row("Tooth thickness, normal, changes by", fixed_text(a.setting->thickness_change, 6) + " mm");
    row("Backlash, normal, changes by", fixed_text(a.setting->backlash_change, 6) + " mm");
  }
  if (a.lead) {
    head("Lead angle that takes the slope out of the transmission error");
    row("Slope in the middle of the mesh", fmt::format("{:.4e}", a.lead->slope));
    row("Change of gear 1's lead angle", degrees(a.lead->exact[0]));
    if (a.lead->first_order) row("  to the first order", degrees(a.lead->first_order));
    row("  or of gear 2's", degrees(a.lead->exact[1]));
  }
  head("Corrections together, for the worst of the errors");
  for (std::size_t i = 0; i < a.corrections.size(); ++i) {
    const std::string key = kCorrections[a.corrections[i]].key;
    row(key, fmt::format("{:.4f} {}", a.result.value[i], unit_of(key)));
  }
  head("                                                before              after");
  const auto both = [&](const std::string& what, const std::string& before,
                        const std::string& after) {
    out += fmt::format("  {:<36}{:>16}{:>19}\n", what, before, after);
  };
  const auto arcsec = [](const ContactScore& s) {
    return std::isfinite(s.peak_to_peak) ? fixed_text(s.peak_to_peak * kArcsec, 4) + " arcsec"
                                         : std::string("no contact");
  };
  both("Transmission error, peak to peak", arcsec(a.result.before), arcsec(a.result.after));
  both("Contact off the middle of the face", percent(a.result.before.along_face),
       percent(a.result.after.along_face));
  if (a.setting)
    both("Contact off the profile's middle", percent(a.result.before.along_profile),
         percent(a.result.after.along_profile));
  if (a.scenarios.size() > 1) {
    for (std::size_t i = 0; i < a.scenarios.size(); ++i)
      both("  " + a.scenarios[i], arcsec(a.result.each_before[i]), arcsec(a.result.each_after[i]));
  }
  return out;
}

}  // namespace gearwright
