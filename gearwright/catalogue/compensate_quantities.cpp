#include "gearwright/catalogue/compensate_quantities.hpp"

#include <cmath>

#include "gearwright/base/units.hpp"

namespace gearwright {

namespace {

using V = CompensateView;

constexpr const char* kSetting = "Setting of rack F that brings the contact back";
constexpr const char* kLead = "Lead angle that removes the slope of the transmission error";

Value degrees(const std::optional<Angle>& angle) { return angle ? Value(angle->deg()) : Value(); }

const QuantityTable& score_table() { return score_quantities().table(); }

const QuantityTable& correction_table() { return correction_quantities().table(); }

const Quantities<Scenario>& scenario_quantities() {
  using S = Scenario;
  static const Quantities<S> kAll("compensate.scenarios", [](Quantities<S>& q) {
    q.text("errors", "in words", [](const S& s) { return Value(s.errors); }).always();
    q.record("", "before", "without corrections", score_table, [](const S& s) {
       return Value(score_quantities().of(s.before));
     }).always();
    q.record("", "after", "with them", score_table, [](const S& s) {
       return Value(score_quantities().of(s.after));
     }).always();
  });
  return kAll;
}
const QuantityTable& scenario_table() { return scenario_quantities().table(); }

const Quantities<SettingAnswer>& angle_quantities() {
  using S = SettingAnswer;
  static const Quantities<S> kAll("compensate.tool_setting angles", [](Quantities<S>& q) {
    q.deg("", "nominal", "pressure angle as drawn", "θ", "at the contact", [](const S& s) {
       return degrees(s.angle_nominal);
     }).digits(6);
    q.deg("", "displaced", "pressure angle with the change of centre distance", "θ", "ΔC",
          [](const S& s) { return degrees(s.angle_displaced); })
        .digits(6);
    q.deg("", "exact", "pressure angle with the exact setting", "θ", "besides", [](const S& s) {
       return degrees(s.angle_exact);
     }).digits(6);
    q.deg("", "first_order", "pressure angle with the first-order setting", "θ", "besides",
          [](const S& s) { return degrees(s.angle_first_order); })
        .digits(6);
  });
  return kAll;
}
const QuantityTable& angle_table() { return angle_quantities().table(); }

const Quantities<SettingAnswer>& setting_quantities() {
  using S = SettingAnswer;
  static const Quantities<S> kAll("compensate.tool_setting", [](Quantities<S>& q) {
    q.mm("", "exact_mm", "change of the centre's place b, exact", "Δb_F", "that answers ΔC [T8.20]",
         [](const S& s) { return Value(s.exact); })
        .digits(6);
    q.mm("", "first_order_mm", "change of the centre's place b, to the first order", "Δb_F",
         "[T8.21]", [](const S& s) { return Value(s.first_order); })
        .digits(6);
    q.record("", "pressure_angle_deg", "at the contact", angle_table,
             [](const S& s) { return Value(angle_quantities().of(s)); });
    q.mm("", "tooth_thickness_change_mm", "change of the normal tooth thickness", "",
         "of the exact setting alone [T8.23]", [](const S& s) { return Value(s.thickness_change); })
        .digits(6);
    q.mm("", "backlash_change_mm", "change of the normal backlash", "",
         "of the exact setting alone [T8.23]", [](const S& s) { return Value(s.backlash_change); })
        .digits(6);
  });
  return kAll;
}
const QuantityTable& setting_table() { return setting_quantities().table(); }

const Quantities<LeadAnswer>& lead_quantities() {
  using L = LeadAnswer;
  static const Quantities<L> kAll("compensate.lead", [](Quantities<L>& q) {
    q.pure("", "slope", "slope of the transmission error", "", "of tooth pair 0 at rotation 0",
           [](const L& l) { return Value(l.slope); })
        .digits(9);
    q.deg("", "cutter_lead1_deg", "change of the lead angle of gear 1", "Δλ_1",
          "that leaves no slope; null: none within 0.57°",
          [](const L& l) { return degrees(l.exact[0]); })
        .digits(6);
    q.deg("", "cutter_lead2_deg", "change of the lead angle of gear 2 instead", "Δλ_2",
          "that leaves no slope; null: none within 0.57°",
          [](const L& l) { return degrees(l.exact[1]); })
        .digits(6);
    q.deg("", "first_order1_deg", "change of gear 1's to the first order", "Δλ_1", "[T8.22]",
          [](const L& l) { return degrees(l.first_order); })
        .digits(6);
  });
  return kAll;
}
const QuantityTable& lead_table() { return lead_quantities().table(); }

const QuantityTable& loaded_score_table() { return loaded_score_quantities().table(); }

const Quantities<AimedLoad>& load_quantities_of_aim() {
  using L = AimedLoad;
  static const Quantities<L> kAll("compensate.under_load", [](Quantities<L>& q) {
    q.add(Type::number, Unit::newton_metre, "", "torque_Nm", "torque", "T_1", "on gear 1",
          [](const L& l) { return Value(l.torque / kMmPerM); })
        .always();
    q.record("", "before", "without corrections", loaded_score_table, [](const L& l) {
       return Value(loaded_score_quantities().of(l.before));
     }).always();
    q.record("", "after", "with them", loaded_score_table, [](const L& l) {
       return Value(loaded_score_quantities().of(l.after));
     }).always();
  });
  return kAll;
}
const QuantityTable& aimed_load_table() { return load_quantities_of_aim().table(); }

bool loaded(const V& v) { return under_load(v.aim); }

void say(Quantities<V>& q) {
  q.groups({kSetting, kLead});
  q.record("", "corrections", "what was found", correction_table,
           [](const V& v) { return Value(correction_quantities().each(v.corrections)); })
      .list({0})
      .always()
      .doors(kJson);
  q.record("", "before", "the worst over all scenarios, without corrections", score_table,
           [](const V& v) { return Value(score_quantities().of(v.before)); })
      .always()
      .doors(kJson);
  q.record("", "after", "the worst over all scenarios, with them", score_table,
           [](const V& v) { return Value(score_quantities().of(v.after)); })
      .always()
      .doors(kJson);
  q.word(
       "", "aim", "what is to be least", "the key of this name",
       [](const V& v) {
         return Value(v.aim == CompensateAim::pressure ? "pressure" : "loaded_transmission_error");
       })
      .one_of({"loaded_transmission_error", "pressure"})
      .when(loaded)
      .doors(kJson);
  q.record("", "under_load", "one for each torque, the worst over all scenarios", aimed_load_table,
           [](const V& v) { return Value(load_quantities_of_aim().each(v.loads)); })
      .list({0})
      .when(loaded)
      .doors(kJson);
  q.flag("", "nothing_to_correct", "nothing to correct",
         "no correction improves the result by 0.001 arcsec, so each is 0",
         [](const V& v) { return Value(v.nothing_to_correct); })
      .doors(kJson);
  q.add(Type::number, Unit::arcsec, "", "centering_arcsec",
        "cost of a pattern at the end of the face", "w",
        "the key of this name, or its default [T8.24]",
        [](const V& v) { return Value(v.centering.arcsec()); })
      .doors(kJson);
  q.record("", "scenarios", "one by one", scenario_table,
           [](const V& v) { return Value(scenario_quantities().each(v.scenarios)); })
      .list({0})
      .always()
      .doors(kJson);
  q.record(kSetting, "tool_setting", "of racks F and P, else null", setting_table, [](const V& v) {
    return v.setting ? Value(setting_quantities().of(*v.setting)) : Value();
  });
  q.record(kLead, "lead",
           "of circular-arc pairs, else null, because the lead of involute pairs is corrected by "
           "slopes",
           lead_table,
           [](const V& v) { return v.lead ? Value(lead_quantities().of(*v.lead)) : Value(); });
  q.add(Type::map, Unit::none, "", "spec", "spec", "", "the whole spec with the corrections in it",
        [](const V& v) { return v.spec; })
      .always()
      .doors(kJson);
}

}  // namespace

const char* least_gain(CompensateAim aim) {
  return aim == CompensateAim::pressure ? "0.1 N/mm²" : "0.001 ″";
}

const Quantities<CompensateView>& compensate_quantities() {
  static const Quantities<CompensateView> kAll("compensate", say);
  return kAll;
}

const Quantities<FoundCorrection>& correction_quantities() {
  using C = FoundCorrection;
  static const Quantities<C> kAll("compensate.corrections", [](Quantities<C>& q) {
    q.text("key", "as in the spec", [](const C& c) { return Value(c.key); }).always();
    q.pure("", "value", "value", "", "in its unit", [](const C& c) {
       return Value(c.value);
     }).always();
    q.text("unit", "as keys end", [](const C& c) { return Value(c.unit); }).always();
    q.text("spec_key", "that contains it in the corrected spec", [](const C& c) {
       return Value(c.spec_key);
     }).always();
    q.flag("", "at_bound", "at the end of the searched range", "more might be better still",
           [](const C& c) { return Value(c.at_bound); })
        .always();
  });
  return kAll;
}

const Quantities<LoadedScore>& loaded_score_quantities() {
  using S = LoadedScore;
  static const Quantities<S> kAll("compensate loaded score", [](Quantities<S>& q) {
    q.add(Type::number, Unit::arcsec, "", "peak_to_peak_arcsec",
          "loaded transmission error, peak to peak", "", "as `load` has it",
          [](const S& s) { return Value(s.peak_to_peak.arcsec()); })
        .always();
    q.add(Type::number, Unit::megapascal, "", "max_pressure_MPa", "greatest pressure", "p_max",
          "of Hertz; a lower bound where an edge carries load",
          [](const S& s) { return Value(s.max_pressure); })
        .always();
    q.pure("", "face_load_factor", "face load factor", "K_Hβ", "as `load` has it", [](const S& s) {
       return Value(s.face_load_factor);
     }).when([](const S& s) { return s.face_load_factor.has_value(); });
    q.flag("", "edge_carries", "an edge carries", "the pressure there is a lower bound",
           [](const S& s) { return Value(s.edge_carries); });
  });
  return kAll;
}

const Quantities<ContactScore>& score_quantities() {
  using S = ContactScore;
  static const Quantities<S> kAll("compensate score", [](Quantities<S>& q) {
    q.add(Type::number, Unit::arcsec, "", "peak_to_peak_arcsec", "transmission error, peak to peak",
          "", "the worst; null without contact",
          [](const S& s) {
            return std::isfinite(s.peak_to_peak.rad()) ? Value(s.peak_to_peak.arcsec()) : Value();
          })
        .otherwise("no contact");
    q.add(Type::number, Unit::percent, "", "contact_along_face",
          "contact off the middle of the face", "", "mean place, ±1 at the ends [T8.24]",
          [](const S& s) { return Value(s.along_face); })
        .digits(1);
    q.add(Type::number, Unit::percent, "", "contact_along_profile",
          "contact off the middle of the profile", "", "mean place, ±1 at the ends [T8.24]",
          [](const S& s) { return Value(s.along_profile); })
        .digits(1);
    q.add(Type::number, Unit::percent, "", "edge_share", "positions with an edge in contact", "",
          "share of the positions of a pitch at which an edge touches, 0 to 1",
          [](const S& s) { return Value(s.edge_share); })
        .digits(1);
    q.flag("", "contact_lost", "contact lost", "somewhere", [](const S& s) {
       return Value(s.lost);
     }).doors(kJson);
  });
  return kAll;
}

}  // namespace gearwright
