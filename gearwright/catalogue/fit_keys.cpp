#include "gearwright/catalogue/fit_keys.hpp"

namespace gearwright {

namespace {

Key of_few_teeth(std::string_view key, std::string_view symbol,
                 std::optional<double> FitInput::*member, std::string_view fallback,
                 std::string_view meaning) {
  const auto set = [member](FitInput& fit, double value) {
    fit.*member = value;
    return std::string(fit.few_teeth ? "" : "is allowed only with few_teeth = true");
  };
  return Key::not_negative(key, symbol, KeyPlace::by<FitInput, double>(set), fallback, meaning)
      .with_needs({"few_teeth"});
}

}  // namespace

const KeyTable& fit_keys() {
  static const KeyTable table{
      "fit",
      "Settings of the verb fit; no other verb reads them",
      {Key::number("working_normal_pressure_angle_deg", "α_wn",
                   KeyRange::between(1, 80, ", usually 14.5 to 30"),
                   &FitInput::working_normal_pressure_angle, "",
                   "working normal pressure angle of the designs"),
       Key::flag("few_teeth", &FitInput::few_teeth, "false",
                 "if true, the pinion has few teeth, and a cutter with the same profile and longer "
                 "teeth generates the wheel or internal gear"),
       of_few_teeth("least_tip_land_mm", "", &FitInput::min_tip_land, "0",
                    "least normal tooth thickness at both tips"),
       of_few_teeth("least_gap_mm", "", &FitInput::min_gap, "0",
                    "least chord of the tooth space at the start of the flanks, for both gears"),
       of_few_teeth("clearance_mm", "", &FitInput::clearance, "0.2 m_n + 0.05",
                    "tip clearance of both gears"),
       of_few_teeth("backlash_mm", "", &FitInput::backlash, "0",
                    "circumferential backlash, which determines the centre distance"),
       of_few_teeth("contact_ratio", "ε_γ", &FitInput::contact_ratio, "1.2",
                    "required total contact ratio, which determines the face width")}};
  return table;
}

}  // namespace gearwright
