#include "gearwright/catalogue/identify_quantities.hpp"

namespace gearwright {

namespace {

using G = IdentifiedGear;

const Quantities<G>& uncertainty_quantities() {
  static const Quantities<G> kAll("identify.uncertainty", [](Quantities<G>& q) {
    q.mm("", "normal_module_mm", "± of the module", "", "95 %; 0 of a standard one",
         [](const G& g) { return Value(g.module_uncertainty); })
        .always()
        .digits(5);
    q.deg("", "helix_angle_deg", "± of the helix angle", "", "95 %; 0 of a whole number of degrees",
          [](const G& g) { return Value(g.helix_uncertainty.deg()); })
        .always()
        .digits(4);
    q.pure("", "profile_shift", "± of the profile shift", "", "95 %",
           [](const G& g) { return Value(g.shift_uncertainty); })
        .always()
        .digits(4);
  });
  return kAll;
}
const QuantityTable& uncertainty_table() { return uncertainty_quantities().table(); }
const QuantityTable& candidate_table() { return identified_gear_quantities().table(); }

Value series_word(const G& g) {
  switch (g.series) {
    case ModuleSeries::iso54_1: return "ISO54-I";
    case ModuleSeries::iso54_2: return "ISO54-II";
    case ModuleSeries::diametral_pitch: return "diametral_pitch";
    case ModuleSeries::none: return "none";
  }
  return {};
}

void say_candidate(Quantities<G>& q) {
  q.whole("", "teeth", "number of teeth", "z", "as counted", [](const G& g) {
     return Value(g.teeth);
   }).always();
  q.mm("", "normal_module_mm", "normal module", "m_n", "of the series below", [](const G& g) {
     return Value(g.normal_module);
   }).always();
  q.word("", "module_series", "series of the module", "`none`: no standard's",
         [](const G& g) { return series_word(g); })
      .always()
      .one_of({"ISO54-I", "ISO54-II", "diametral_pitch", "none"});
  q.pure("", "normal_diametral_pitch_per_in", "diametral pitch", "P_nd", "null: of a metric gear",
         [](const G& g) { return Value(g.diametral_pitch); });
  q.deg("", "normal_pressure_angle_deg", "normal pressure angle", "α_n", "", [](const G& g) {
     return Value(g.normal_pressure_angle.deg());
   }).always();
  q.deg("", "helix_angle_deg", "helix angle", "β",
        "> 0 right hand, also if no reading determines the hand",
        [](const G& g) { return Value(g.helix_angle.deg()); })
      .always();
  q.pure("", "profile_shift", "profile shift coefficient", "x_E",
         "of the actual teeth, including the thickness allowance",
         [](const G& g) { return Value(g.generating_shift); })
      .always();
  q.pure("", "generating_profile_shift", "generating profile shift coefficient", "x_E", "the same",
         [](const G& g) { return Value(g.generating_shift); })
      .always()
      .doors(kJson);
  q.mm("", "tip_diameter_mm", "tip diameter", "d_a",
       "the reading, if it is greater than the profile shift alone gives; a worn tip is not",
       [](const G& g) { return Value(g.tip_diameter); })
      .always();
  q.pure(
      "", "profile_shift_of_tip", "shift that the tip shows", "x",
      "null: no tip was measured. If it is greater than x_E, it is that of the drawing or a part "
      "of it left by wear; the difference to x_E is the thickness allowance",
      [](const G& g) { return Value(g.shift_of_tip); });
  q.add(Type::number, Unit::percent, "", "likelihood", "likelihood", "", "of all candidates 1",
        [](const G& g) { return Value(g.likelihood); })
      .always()
      .digits(2)
      .greater_first();
  q.record("", "uncertainty", "± of 95 %", uncertainty_table, [](const G& g) {
     return Value(uncertainty_quantities().of(g));
   }).always();
}

const Quantities<Contradiction>& contradiction_quantities() {
  using C = Contradiction;
  static const Quantities<C> kAll("identify.contradiction", [](Quantities<C>& q) {
    q.word("", "reading", "reading that disagrees", "with all others",
           [](const C& c) { return Value(c.reading); })
        .always()
        .one_of({"span", "over_balls", "lead", "helix_angle"});
    q.pure("", "tool", "its teeth or balls", "k, D_M", "null: it has none",
           [](const C& c) { return c.tool > 0.0 ? Value(c.tool) : Value(); });
    q.pure("", "value", "as it was read", "", "mm, or degrees", [](const C& c) {
       return Value(c.value);
     }).always();
    q.pure("", "expected", "as the others want it", "", "mm, or degrees", [](const C& c) {
       return Value(c.expected);
     }).always();
  });
  return kAll;
}
const QuantityTable& contradiction_table() { return contradiction_quantities().table(); }

const Quantities<NextMeasurement>& next_quantities() {
  using N = NextMeasurement;
  static const Quantities<N> kAll("identify.next_measurement", [](Quantities<N>& q) {
    q.word("", "reading", "what to measure next", "", [](const N& n) { return Value(n.reading); })
        .always()
        .one_of({"span", "over_balls", "helix_angle"});
    q.pure("", "tool", "its teeth or balls", "k, D_M", "null: it has none",
           [](const N& n) { return n.tool > 0.0 ? Value(n.tool) : Value(); });
    q.pure("", "expect", "of the first candidate, of the other", "", "mm, or degrees",
           [](const N& n) { return Value(n.expect); })
        .list({2})
        .always();
    q.whole("", "rival", "the other candidate", "", "its place in the list, from 0",
            [](const N& n) { return Value(n.rival); })
        .always();
  });
  return kAll;
}
const QuantityTable& next_table() { return next_quantities().table(); }

}  // namespace

const Quantities<IdentifiedGear>& identified_gear_quantities() {
  static const Quantities<G> kAll("identify.candidate", say_candidate);
  return kAll;
}

const Quantities<Identification>& identify_quantities() {
  using I = Identification;
  static const Quantities<I> kAll("identify", [](Quantities<I>& q) {
    q.record("Candidate", "candidates",
             "the gears that it could be, likeliest first, each as in a spec", candidate_table,
             [](const I& i) { return Value(identified_gear_quantities().each(i.candidates)); })
        .list({0})
        .always();
    q.record("Contradiction", "contradiction",
             "null: the readings agree; the candidates are those of the other readings",
             contradiction_table, [](const I& i) {
               return i.contradiction ? Value(contradiction_quantities().of(*i.contradiction))
                                      : Value();
             });
    q.record("Next measurement", "next_measurement",
             "null: only one candidate is left, or no measurement can decide", next_table,
             [](const I& i) { return i.next ? Value(next_quantities().of(*i.next)) : Value(); });
    q.text("reason", "why there is no candidate, or none that fits; null: at least one fits",
           [](const I& i) { return i.reason.empty() ? Value() : Value(i.reason); });
  });
  return kAll;
}

}  // namespace gearwright
