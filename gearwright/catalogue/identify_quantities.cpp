#include "gearwright/catalogue/identify_quantities.hpp"

namespace gearwright {

namespace {

using G = IdentifiedGear;

const Quantities<G>& uncertainty_quantities() {
  static const Quantities<G> kAll("identify.uncertainty", [](Quantities<G>& q) {
    q.number("normal_module_mm", "± of the module", "", "95 %; 0 for a standard module",
             &G::module_uncertainty)
        .always()
        .digits(5);
    q.number("helix_angle_deg", "± of the helix angle", "", "95 %; 0 for a whole number of degrees",
             &G::helix_uncertainty)
        .always()
        .digits(4);
    q.number("profile_shift", "± of the profile shift", "", "95 %", &G::shift_uncertainty)
        .always()
        .digits(4);
  });
  return kAll;
}

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
  q.under("");
  q.term("teeth", "as counted", &G::teeth).always();
  q.term("normal_module_mm", "of the series below", &G::normal_module).always();
  q.word("module_series", "series of the module", "`none` if it is not of a standard",
         [](const G& g) { return series_word(g); })
      .always()
      .one_of({"ISO54-I", "ISO54-II", "diametral_pitch", "none"});
  q.number("normal_diametral_pitch_per_in", "diametral pitch", "P_nd", "null for a metric gear",
           &G::diametral_pitch);
  q.term("normal_pressure_angle_deg", "", &G::normal_pressure_angle).always();
  q.term("helix_angle_deg", "> 0 right hand, also if no reading determines the hand",
         &G::helix_angle)
      .always();
  q.number("profile_shift", "profile shift coefficient", "x_E",
           "of the actual teeth, including the thickness allowance", &G::generating_shift)
      .always();
  q.term("generating_profile_shift", "the same", &G::generating_shift).always().doors(kJson);
  q.term("tip_diameter_mm",
         "the measured value, if it is greater than that from the profile shift; a worn tip is "
         "smaller",
         &G::tip_diameter)
      .always();
  q.number(
      "profile_shift_of_tip", "shift that the tip shows", "x",
      "null if no tip was measured. If it is greater than x_E, it is that of the drawing or a part "
      "of it left by wear; the difference to x_E is the thickness allowance",
      &G::shift_of_tip);
  q.number("likelihood", "likelihood", "", "of all candidates 1", &G::likelihood)
      .unit(Unit::percent)
      .always()
      .digits(2)
      .greater_first();
  q.record<uncertainty_quantities>(
       "uncertainty", "± of 95 %", [](const G& g) -> const auto& { return g; })
      .always();
}

const Quantities<Contradiction>& contradiction_quantities() {
  using C = Contradiction;
  static const Quantities<C> kAll("identify.contradiction", [](Quantities<C>& q) {
    q.word("reading", "reading that disagrees", "with all others", &C::reading)
        .always()
        .one_of({"span", "over_balls", "lead", "helix_angle"});
    q.term("tool", "null if it has none",
           [](const C& c) { return c.tool > 0.0 ? Value(c.tool) : Value(); });
    q.number("value", "as it was read", "", "mm, or degrees", &C::value).always();
    q.number("expected", "value predicted by the other readings", "", "mm, or degrees",
             &C::expected)
        .always();
  });
  return kAll;
}

const Quantities<NextMeasurement>& next_quantities() {
  using N = NextMeasurement;
  static const Quantities<N> kAll("identify.next_measurement", [](Quantities<N>& q) {
    q.word("reading", "what to measure next", "", &N::reading)
        .always()
        .one_of({"span", "over_balls", "helix_angle"});
    q.term("tool", "null if it has none",
           [](const N& n) { return n.tool > 0.0 ? Value(n.tool) : Value(); });
    q.number("expect", "of the first candidate, of the other", "", "mm, or degrees", &N::expect)
        .list({2})
        .always();
    q.whole("rival", "the other candidate", "", "its place in the list, from 0", &N::rival)
        .always();
  });
  return kAll;
}

}  // namespace

const Quantities<IdentifiedGear>& identified_gear_quantities() {
  static const Quantities<G> kAll("identify.candidate", say_candidate);
  return kAll;
}

const Quantities<Identification>& identify_quantities() {
  using I = Identification;
  static const Quantities<I> kAll("identify", [](Quantities<I>& q) {
    q.under("Candidate");
    q.record<identified_gear_quantities>(
         "candidates", "the possible gears, likeliest first, each as in a spec", &I::candidates)
        .list({0})
        .always();
    q.under("Contradiction");
    q.record<contradiction_quantities>(
        "contradiction",
        "null if the readings agree; the candidates are those of the other readings",
        &I::contradiction);
    q.under("Next measurement");
    q.record<next_quantities>("next_measurement",
                              "null if only one candidate is left or no measurement can decide",
                              &I::next);
    q.text("reason", "why there is no candidate, or none that fits; null if at least one fits",
           [](const I& i) { return i.reason.empty() ? Value() : Value(i.reason); });
  });
  return kAll;
}

}  // namespace gearwright
