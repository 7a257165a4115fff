#include "gearwright/catalogue/fit_quantities.hpp"

namespace gearwright {

namespace {

using G = IdentifiedGear;

const Quantities<G>& uncertainty_quantities() {
  return define("identify.uncertainty", [](Quantities<G>& q) {
    q.number("normal_module_mm", "uncertainty of the module", "",
             "95 % interval; 0 for a standard module", &G::module_uncertainty)
        .digits(5);
    q.number("helix_angle_deg", "uncertainty of the helix angle", "",
             "95 % interval; 0 for a whole number of degrees", &G::helix_uncertainty)
        .digits(4);
    q.number("profile_shift", "uncertainty of the profile shift", "", "95 % interval",
             &G::shift_uncertainty)
        .digits(4);
  });
}

Value tip_word(const G& g) {
  switch (g.tip) {
    case TipReading::none: return {};
    case TipReading::as_drawn: return "as_drawn";
    case TipReading::worn: return "worn";
    case TipReading::shortened: return "shortened";
    case TipReading::longer: return "longer";
  }
  return {};
}

const Quantities<G>& drawing_quantities() {
  return define("identify.drawing", [](Quantities<G>& q) {
    q.word("rack", "basic rack",
           "the named rack that agrees best with tip and root; null if the spec gives the rack",
           [](const G& g) { return g.rack.empty() ? Value() : Value(g.rack); })
        .one_of({"ISO53-A", "ISO53-D", "AGMA-14.5", "AGMA-20", "AGMA-25", "AGMA-stub"});
    q.term("profile_shift",
           "x in x_E = x + E_sn/(2 m_n tan α_n) [T10.34]. The value 0 is chosen if it gives a "
           "usual allowance and agrees with the tip. Otherwise, x is computed from the tip; if "
           "the tip does not determine x, x = x_E",
           &G::profile_shift);
    q.term("thickness_allowance_mm",
           "allowance of the normal tooth thickness, including wear of the flanks",
           &G::thickness_allowance);
    q.number("nominal_tip_diameter_mm", "nominal tip diameter", "d_a",
             "tip diameter that the rack and the profile shift give", &G::nominal_tip_diameter);
    q.term("root_diameter_mm", "as cut by the rack", &G::root_diameter);
    q.word("tip", "tip",
           "the measured tip in comparison with the nominal tip; `tip_diameter_mm` is the measured "
           "value if the tip is longer or shortened; null if the tip was not measured",
           tip_word)
        .one_of({"as_drawn", "worn", "shortened", "longer"});
  });
}

const char* series_word(const G& g) {
  switch (g.series) {
    case ModuleSeries::iso54_1: return "ISO54-I";
    case ModuleSeries::iso54_2: return "ISO54-II";
    case ModuleSeries::diametral_pitch: return "diametral_pitch";
    case ModuleSeries::none: return "none";
  }
  return "";
}

void add_candidate(Quantities<CandidateView>& q) {
  q.term("teeth", "as given", &G::teeth);
  q.term("normal_module_mm",
         "module of the series, or computed from the base pitch if `module_series` is `none`",
         &G::normal_module);
  q.word("module_series", "series of the module", "`none` if the module is not in a series",
         series_word)
      .one_of({"ISO54-I", "ISO54-II", "diametral_pitch", "none"});
  q.number("normal_diametral_pitch_per_in", "diametral pitch", "P_nd", "null for a metric gear",
           &G::diametral_pitch);
  q.term("normal_pressure_angle_deg", "", &G::normal_pressure_angle);
  q.term("helix_angle_deg",
         "> 0 right hand; a right hand is assumed if no reading determines the hand",
         &G::helix_angle);
  q.number("profile_shift", "profile shift coefficient", "x_E",
           "profile shift of the actual teeth, including the thickness allowance",
           &G::generating_shift);
  q.term("generating_profile_shift", "equal to `profile_shift`", &G::generating_shift).doors(kJson);
  q.term(
      "tip_diameter_mm",
      "the nominal tip of `drawing` if the tip was not measured, or if the measured tip is shorter "
      "by at most 0.1 m_n in radius, which is attributed to wear; otherwise the measured value",
      &G::tip_diameter);
  q.number("profile_shift_of_tip", "profile shift by the tip", "x",
           "profile shift computed from the measured tip and the rack of `drawing`; too low if the "
           "tip is worn; null if the tip was not measured",
           &G::shift_of_tip);
  q.number("likelihood", "likelihood", "",
           "probability of the candidate; the sum over all candidates is 100 %", &G::likelihood)
      .unit(Unit::percent)
      .digits(2)
      .greater_first();
  q.flag("plausible", "plausible", "false if |x_E| > 1.5, because such gears do not occur",
         &G::plausible);
  const auto gear = [](const CandidateView& c) -> const G& { return c; };
  q.record<drawing_quantities>("drawing", "the values with which a drawing describes the gear",
                               gear);
  q.record<uncertainty_quantities>("uncertainty", "half widths of the 95 % intervals of the values",
                                   gear);
  q.add(Type::map, "spec", "spec", "",
        "the complete spec with this gear, which describes its teeth by the values of `drawing`; "
        "absent for an alternative",
        &CandidateView::spec)
      .always()
      .doors(kJson)
      .when([](const CandidateView& c) { return !c.spec.nothing(); });
}

constexpr const char* kReadings[] = {
    "span",          "over_balls",      "lead",  "helix_angle", "tip_diameter",
    "root_diameter", "center_distance", "teeth", "all",         "span_teeth"};

const char* word_of(Reading reading) { return kReadings[static_cast<std::size_t>(reading)]; }

template <class R>
void add_units(Quantities<R>& q) {
  q.text("unit", "unit of the reading, spelled as in keys",
         [](const R& r) { return r.reading == Reading::helix_angle ? "deg" : "mm"; });
  q.text("tool_unit", "unit of the diameter of the balls; null for other readings",
         [](const R& r) { return r.reading == Reading::over_balls ? Value("mm") : Value(); });
}

const Quantities<Contradiction>& contradiction_quantities() {
  using C = Contradiction;
  return define("identify.contradiction", [](Quantities<C>& q) {
    q.word("reading", "contradictory reading", "the reading that contradicts all others",
           [](const C& c) { return word_of(c.reading); })
        .one_of({"span", "over_balls", "lead", "helix_angle", "tip_diameter", "root_diameter"});
    q.term("tool",
           "for a span, the number of teeth between the anvils; for balls, their diameter; null "
           "for other readings",
           [](const C& c) { return c.tool > 0.0 ? Value(c.tool) : Value(); });
    q.number("value", "value as read", "", "in `unit`", &C::value);
    q.number("expected", "value of this reading that the other readings predict", "",
             "in `unit`; null for the infinite lead of a spur gear", &C::expected);
    add_units(q);
  });
}

const Quantities<NextMeasurement>& next_quantities() {
  using N = NextMeasurement;
  return define("identify.next_measurement", [](Quantities<N>& q) {
    q.word("reading", "next measurement", "", [](const N& n) {
       return word_of(n.reading);
     }).one_of({"span", "over_balls", "helix_angle"});
    q.term("tool",
           "for a span, the number of teeth between the anvils; for balls, their diameter; null "
           "for other measurements",
           [](const N& n) { return n.tool > 0.0 ? Value(n.tool) : Value(); });
    q.number("expect", "values of this measurement that the first and the other candidate predict",
             "", "in `unit`", &N::expect)
        .list({2});
    add_units(q);
    q.whole("rival", "the other candidate", "",
            "position of the other candidate in the list, from 0", &N::rival);
  });
}

const Quantities<Alternative>& alternative_quantities() {
  using A = Alternative;
  return define("identify.alternative", [](Quantities<A>& q) {
    q.word("mistake", "mistake",
           "`teeth` if the number of teeth is wrong; `span_teeth` if the number of teeth in each "
           "span is wrong; otherwise the readings that are in the wrong unit (mm instead of inch, "
           "or inch instead of mm)",
           [](const A& a) { return word_of(a.mistake); })
        .one_of({"teeth", "all", "span", "over_balls", "tip_diameter", "root_diameter",
                 "center_distance", "span_teeth"});
    q.record<candidate_quantities>("gear", "the gear",
                                   [](const A& a) { return CandidateView{a.gear}; });
  });
}

}  // namespace

const Quantities<CandidateView>& candidate_quantities() {
  return define<add_candidate>("identify.candidate");
}

const Quantities<IdentifyView>& identify_quantities() {
  using V = IdentifyView;
  return define("identify", [](Quantities<V>& q) {
    q.under("Candidate");
    q.record<candidate_quantities>("candidates", "possible gears, the likeliest first",
                                   &V::candidates);
    q.under("Contradiction");
    q.record<contradiction_quantities>("contradiction",
                                       "reading that contradicts the others; the candidates are "
                                       "computed without this reading; null if the readings agree",
                                       [](const V& v) { return v.found.contradiction; });
    q.under("Next measurement");
    q.record<next_quantities>("next_measurement",
                              "measurement that separates the first candidate from the greatest "
                              "part of the probability of the others; null if only one candidate "
                              "is left or no measurement distinguishes them",
                              [](const V& v) { return v.found.next; });
    q.under("Alternative");
    q.record<alternative_quantities>(
        "alternative",
        "a gear that agrees with all readings if one input is corrected; null if the readings "
        "agree "
        "with a standard gear, or if no single correction makes the readings agree",
        [](const V& v) { return v.found.alternative; });
    q.text("reason",
           "reason why no candidate fits the readings; null if at least one candidate fits",
           [](const V& v) { return v.found.reason.empty() ? Value() : Value(v.found.reason); });
  });
}

}  // namespace gearwright
