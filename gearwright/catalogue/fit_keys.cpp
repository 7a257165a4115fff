#include "gearwright/catalogue/fit_keys.hpp"

namespace gearwright {

const KeyTable& fit_keys() {
  static const KeyTable table{
      "fit",
      "What the verb fit is asked; no other verb reads it",
      {{.key = "working_normal_pressure_angle_deg",
        .symbol = "α_wn",
        .range = KeyRange::between(1, 80, ", usually 14.5 to 30"),
        .place = &FitInput::working_normal_pressure_angle,
        .meaning = "working normal pressure angle of the designs wanted"},
       {.key = "few_teeth",
        .kind = KeyKind::boolean,
        .place = &FitInput::few_teeth,
        .fallback = "false",
        .meaning =
            "the pinion of few teeth and the wheel, or internal gear, that its longer twin cuts"},
       {.key = "least_tip_land_mm",
        .range = KeyRange::not_negative(),
        .place = &FitInput::min_tip_land,
        .needs = {"few_teeth"},
        .fallback = "0",
        .meaning = "least normal thickness at both tips"},
       {.key = "least_gap_mm",
        .range = KeyRange::not_negative(),
        .place = &FitInput::min_gap,
        .needs = {"few_teeth"},
        .fallback = "0",
        .meaning = "least chord of both spaces where the flanks begin"},
       {.key = "clearance_mm",
        .range = KeyRange::not_negative(),
        .place = &FitInput::clearance,
        .needs = {"few_teeth"},
        .fallback = "0.2 m_n + 0.05",
        .meaning = "clearance at both tips"},
       {.key = "backlash_mm",
        .range = KeyRange::not_negative(),
        .place = &FitInput::backlash,
        .needs = {"few_teeth"},
        .fallback = "0",
        .meaning = "circumferential backlash; the centre distance makes it"},
       {.key = "contact_ratio",
        .symbol = "ε_γ",
        .range = KeyRange::not_negative(),
        .place = &FitInput::contact_ratio,
        .needs = {"few_teeth"},
        .fallback = "1.2",
        .meaning = "total contact ratio, for the face width"}}};
  return table;
}

}  // namespace gearwright
