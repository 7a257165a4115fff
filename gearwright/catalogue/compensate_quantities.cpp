#include "gearwright/catalogue/compensate_quantities.hpp"

#include <fmt/format.h>

#include <cmath>

#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/error_keys.hpp"

namespace gearwright {

namespace {

constexpr const char* kSetting = "Setting of rack F that restores the contact";
constexpr const char* kLead = "Lead angle that removes the slope of the transmission error";

const Quantities<Scenario>& scenario_quantities() {
  using S = Scenario;
  return define("compensate.scenarios", [](Quantities<S>& q) {
    q.text("errors", "errors of the scenario, in words",
           [](const S& s) { return errors_text(s.errors); });
    q.record<score_quantities>("before", "scores without corrections", &S::before);
    q.record<score_quantities>("after", "scores with the corrections", &S::after);
  });
}

const Quantities<SettingAnswer>& angle_quantities() {
  using S = SettingAnswer;
  return define("compensate.tool_setting angles", [](Quantities<S>& q) {
    q.number("nominal", "pressure angle as drawn", "θ", "at the contact", &S::angle_nominal)
        .unit(Unit::deg)
        .digits(6);
    q.number("displaced", "pressure angle with the change of centre distance", "θ",
             "under ΔC, without a setting", &S::angle_displaced)
        .unit(Unit::deg)
        .digits(6);
    q.number("exact", "pressure angle with the exact setting", "θ", "under ΔC", &S::angle_exact)
        .unit(Unit::deg)
        .digits(6);
    q.number("first_order", "pressure angle with the first-order setting", "θ", "under ΔC",
             &S::angle_first_order)
        .unit(Unit::deg)
        .digits(6);
  });
}

const Quantities<SettingAnswer>& setting_quantities() {
  using S = SettingAnswer;
  return define("compensate.tool_setting", [](Quantities<S>& q) {
    q.number("exact_mm", "exact change of the position b of the arc centre", "Δb_F",
             "change of b that compensates ΔC [T8.20]", &S::exact)
        .digits(6);
    q.number("first_order_mm", "change of the position b of the arc centre, to first order", "Δb_F",
             "[T8.21]", &S::first_order)
        .digits(6);
    q.record<angle_quantities>("pressure_angle_deg", "pressure angles at the contact");
    q.number("tooth_thickness_change_mm", "change of the normal tooth thickness", "",
             "for the exact setting only [T8.23]", &S::thickness_change)
        .digits(6);
    q.number("backlash_change_mm", "change of the normal backlash", "",
             "for the exact setting only [T8.23]", &S::backlash_change)
        .digits(6);
  });
}

const Quantities<LeadAnswer>& lead_quantities() {
  using L = LeadAnswer;
  return define("compensate.lead", [](Quantities<L>& q) {
    q.number("slope", "slope of the transmission error", "", "for tooth pair 0 at rotation 0",
             &L::slope)
        .digits(9);
    q.number("cutter_lead1_deg", "change of the lead angle of gear 1", "Δλ_1",
             "change that removes the slope; null if no change within ±0.57° removes it",
             [](const L& l) { return l.exact[0]; })
        .digits(6);
    q.number("cutter_lead2_deg", "alternative change of the lead angle of gear 2", "Δλ_2",
             "change that removes the slope; null if no change within ±0.57° removes it",
             [](const L& l) { return l.exact[1]; })
        .digits(6);
    q.number("first_order1_deg", "change of the lead angle of gear 1, to first order", "Δλ_1",
             "[T8.22]", &L::first_order)
        .digits(6);
  });
}

const Quantities<AimedLoad>& load_quantities_of_aim() {
  using L = AimedLoad;
  return define("compensate.under_load", [](Quantities<L>& q) {
    q.term("torque_Nm", "on gear 1", [](const L& l) { return newton_metres(l.torque); });
    q.record<loaded_score_quantities>("before", "without corrections", &L::before);
    q.record<loaded_score_quantities>("after", "with the corrections", &L::after);
  });
}

bool loaded(const CompensateView& v) { return under_load(v.aim); }

void add_compensation(Quantities<CompensateView>& q) {
  q.groups({kSetting, kLead});
  q.record<correction_quantities>("corrections", "corrections that were found",
                                  &CompensateView::corrections)
      .doors(kJson);
  q.record<score_quantities>("before",
                             "worst value of each score over all scenarios, without corrections",
                             &CompensateView::before)
      .doors(kJson);
  q.record<score_quantities>("after",
                             "worst value of each score over all scenarios, with the corrections",
                             &CompensateView::after)
      .doors(kJson);
  q.word("aim", "minimised quantity", "value of the key `aim`",
         [](const CompensateView& v) {
           return v.aim == CompensateAim::pressure ? "pressure" : "loaded_transmission_error";
         })
      .one_of({"loaded_transmission_error", "pressure"})
      .when(loaded)
      .doors(kJson);
  q.record<load_quantities_of_aim>(
       "under_load",
       "one entry for each torque, with the worst value of each score over all scenarios",
       &CompensateView::loads)
      .when(loaded)
      .doors(kJson);
  q.flag("nothing_to_correct", "no correction needed",
         "true if every correction is 0, because no correction improves the result by 0.001 arcsec "
         "(for `pressure`, by 0.1 MPa)",
         &CompensateView::nothing_to_correct)
      .doors(kJson);
  q.number("centering_arcsec", "penalty for a contact pattern at the end of the face", "w",
           "value of the key `centering_arcsec`, or its default [T8.24]",
           &CompensateView::centering)
      .doors(kJson);
  q.record<scenario_quantities>("scenarios",
                                "each scenario (combination of errors) with its scores",
                                &CompensateView::scenarios)
      .doors(kJson);
  q.under(kSetting);
  q.record<setting_quantities>(
      "tool_setting", "setting of rack F for gears cut by racks F and P; null for other gears",
      &CompensateView::setting);
  q.under(kLead);
  q.record<lead_quantities>("lead",
                            "change of the lead for circular-arc pairs; null for involute pairs, "
                            "whose lead is corrected by helix slope modifications",
                            &CompensateView::lead);
  q.add(Type::map, "spec", "spec", "", "the complete spec with the corrections",
        &CompensateView::spec)
      .always()
      .doors(kJson);
}

}  // namespace

std::string errors_text(const std::vector<ErrorValue>& errors) {
  if (errors.empty()) return "as given";
  std::string text;
  for (const auto& [index, value] : errors)
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", error_entries()[index].key, value);
  return text;
}

const char* least_gain(CompensateAim aim) {
  return aim == CompensateAim::pressure ? "0.1 N/mm²" : "0.001 ″";
}

const Quantities<CompensateView>& compensate_quantities() {
  return define<add_compensation>("compensate");
}

const Quantities<FoundCorrection>& correction_quantities() {
  using C = FoundCorrection;
  return define("compensate.corrections", [](Quantities<C>& q) {
    q.text("key", "key of the correction, as in the spec", &C::key);
    q.text("words", "correction in words", &C::words);
    q.number("value", "value", "", "in the unit of the correction", &C::value);
    q.text("unit", "unit of the value, spelled as in keys", &C::unit);
    q.text("spec_key", "key that contains the correction in the corrected spec", &C::spec_key);
    q.flag("at_bound", "at the end of the searched range",
           "true if a greater correction might be better", &C::at_bound);
  });
}

const Quantities<LoadedScore>& loaded_score_quantities() {
  using S = LoadedScore;
  return define("compensate loaded score", [](Quantities<S>& q) {
    q.term("peak_to_peak_arcsec", "computed as in `load`", &S::peak_to_peak)
        .words("loaded transmission error, peak to peak");
    q.term("max_pressure_MPa", "Hertz pressure; a lower bound if an edge carries load",
           &S::max_pressure);
    q.term("face_load_factor", "computed as in `load`", &S::face_load_factor).when([](const S& s) {
      return s.face_load_factor.has_value();
    });
    q.term("edge_carries", "true if an edge carries load, so that the pressure is a lower bound",
           &S::edge_carries);
  });
}

const Quantities<ContactScore>& score_quantities() {
  using S = ContactScore;
  return define("compensate score", [](Quantities<S>& q) {
    q.term("peak_to_peak_arcsec", "greatest value over the scenarios; null without contact",
           [](const S& s) {
             return std::isfinite(s.peak_to_peak.rad()) ? Value(s.peak_to_peak.arcsec()) : Value();
           })
        .otherwise("no contact")
        .doors(kJson);
    q.term("continuous_peak_to_peak_arcsec",
           "greatest value over the scenarios; null if contact is lost at some position",
           [](const S& s) { return s.lost ? std::nullopt : s.span; })
        .otherwise("contact is lost");
    q.number("contact_along_face", "contact offset along the face", "",
             "mean position, ±1 at the ends [T8.24]", &S::along_face)
        .or_null()
        .unit(Unit::percent)
        .digits(1);
    q.number(
         "pattern_along_face", "middle of the contact pattern along the face", "q",
         "mean position, ±1 at the ends, of the flank areas whose gap is small; unlike "
         "`contact_along_face`, it has no jump for flanks without crowning, and the corrections "
         "minimise it [T8.24]",
         &S::pattern_middle)
        .or_null()
        .unit(Unit::percent)
        .digits(1);
    q.number("contact_along_profile", "contact offset along the profile", "",
             "mean position, ±1 at the ends [T8.24]", &S::along_profile)
        .or_null()
        .unit(Unit::percent)
        .digits(1);
    q.number("edge_share", "positions with an edge in contact", "",
             "share of the positions within one pitch at which an edge touches, 0 to 1",
             &S::edge_share)
        .or_null()
        .unit(Unit::percent)
        .digits(1);
    q.term("contact_lost", "true if there is a position at which no teeth touch", &S::lost)
        .doors(kJson);
  });
}

}  // namespace gearwright
