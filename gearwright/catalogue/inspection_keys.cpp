
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/inspection/identify.hpp"

namespace gearwright {

KeyRange flank_classes() {
  return KeyRange::between(0, 12,
                           "; ISO 1328-1:2013 has the flank tolerance classes 1 to 11, and ISO "
                           "1328-1:1995 has 0 to 12");
}

const KeyTable& measure_keys() {
  static const KeyTable table{
      "measure",
      "Positions and tools of the measurements; only the verb `measure` reads this table",
      {Key::positive("chord_diameter_mm", "", &MeasureInput::chord_diameter,
                     "the reference diameter, or the middle of the usable flank if the flank does "
                     "not contain the reference diameter",
                     "diameter on the usable flank at which the jaws of the calliper touch; the "
                     "tooth thickness is also given at this diameter"),
       Key::number(
           "span_teeth", "k", KeyRange::between(1, 1e5), &MeasureInput::span_teeth,
           "the number of teeth for which the contacts are nearest to the V circle d + 2 x m_n",
           "number of teeth (tooth spaces for an internal gear) between the anvils of a span "
           "measurement")
           .with_also({"span", "teeth", "k", "number_of_teeth_spanned"}),
       Key::positive(
           "ball_diameter_mm", "D_M", &MeasureInput::ball_diameter,
           "`pin_diameter_mm`, otherwise the standard size nearest to the size of a ball that "
           "touches at the V circle",
           "diameter of the measuring balls")
           .with_also({"ball", "balls", "dm"}),
       Key::positive("pin_diameter_mm", "D_M", &MeasureInput::pin_diameter, "diameter of the balls",
                     "diameter of the measuring pins (rollers, wires)")
           .with_also({"pin", "pins", "wire", "roller"})}};
  return table;
}

const KeyTable& tolerance_keys() {
  static const KeyTable table{
      "tolerance",
      "The accuracy grade of the flanks, the limits of the tooth thickness and the runout of the "
      "blank",
      {Key::number("quality", "", flank_classes(), &ToleranceInput::quality, "no tolerances",
                   "flank tolerance class (grade) of ISO 1328-1")
           .with_also({"grade", "class", "accuracy_grade"}),
       Key::word("edition", {"ISO 1328:2013", "ISO 1328:1995"}, &ToleranceInput::edition,
                 "\"ISO 1328:2013\"", "edition of the standard for the tolerances")
           .with_also({"standard"}),
       Key::text("thickness_series", &ToleranceInput::series, "",
                 "allowance series (a, ab, b, bc, c, cd, d, e, f, g or h) and tolerance series (21 "
                 "to 30) of DIN 3967, for example `\"cd25\"`; instead of `thickness_allowance_mm`")
           .with_fields({"series"})
           .with_also({"din3967", "series"}),
       Key::number("span_mm", "", {}, &ToleranceInput::span, "",
                   "least and greatest span over `span_teeth` of `[gearN.measure]`; these spans "
                   "determine the allowances")
           .with_list(kLowerAndUpper)
           .with_excludes({"thickness_series"}),
       Key::number("over_balls_mm", "", {}, &ToleranceInput::over_balls, "",
                   "least and greatest dimension over balls, or between balls for an internal "
                   "gear; these dimensions determine the allowances; the diameter of the balls is "
                   "`ball_diameter_mm` of `[gearN.measure]`")
           .with_list(kLowerAndUpper)
           .with_excludes({"thickness_series", "span_mm"}),
       Key::number("tip_diameter_deviations_mm", "A_da", {}, &ToleranceInput::tip_deviations,
                   "the tip diameter has no tolerance",
                   "lower and upper deviation of the tip diameter; every number that depends on "
                   "the tip diameter has an interval")
           .with_list(kLowerAndUpper)
           .with_fields({"tip_deviations"})
           .with_also({"a_da", "tip_diameter_tolerance", "tip_tolerance", "tip_allowance"}),
       Key::text("tip_diameter_fit", &ToleranceInput::tip_fit, "",
                 "fit of the tip diameter by ISO 286 (h1 to h12 or js1 to js12; for an internal "
                 "gear, H1 to H12 or JS1 to JS12); the drawing shows the fit and the limits")
           .with_form("a fit such as \"h9\"")
           .with_fields({"tip_fit"})
           .with_excludes({"tip_diameter_deviations_mm"})
           .with_also({"tip_fit"}),
       Key::positive("tip_runout_um", "", &ToleranceInput::tip_runout_um,
                     "a blank tolerance frame in the drawing",
                     "circular runout of the tip circle to the datum axis by ISO 1101, for the "
                     "drawing")
           .with_fields({"tip_runout"}),
       Key::positive("face_runout_um", "", &ToleranceInput::face_runout_um,
                     "a blank tolerance frame in the drawing",
                     "circular axial runout of both faces to the datum axis by ISO 1101, for the "
                     "drawing")
           .with_fields({"face_runout"})
           .with_also({"axial_runout_um"})}};
  return table;
}

const KeyTable& measured_keys() {
  using I = IdentifyProblem;
  static const KeyTable table{
      "measured",
      "Readings of an unknown gear for the verb `identify`; uncertainties are 95 % intervals",
      {{.key = "span_mm",
        .symbol = "W_k",
        .kind = KeyKind::any,
        .form = "a table with one reading for each number of teeth, for example { 3 = 19.751, 4 = "
                "27.131 }",
        .meaning = "span over k teeth (tooth spaces for an internal gear) for each k, for example "
                   "`{ 3 = 19.751, 4 = 27.131 }`"},
       Key::positive("span_uncertainty_mm", "", &I::span_uncertainty, "0.02",
                     "uncertainty of each span"),
       {.key = "over_balls_mm",
        .symbol = "M_dK",
        .kind = KeyKind::table,
        .list = KeyList{.most = kMostBallReadings,
                        .must = "must be a list of 1 to {} tables, for example [{{ "
                                "ball_diameter_mm = 5, dimension_mm = 69.426 }}]"},
        .place = &I::balls,
        .tables = {measured_ball_keys},
        .meaning = "dimensions over two balls, or between two balls for an internal gear, for "
                   "example `[{ ball_diameter_mm = 5, dimension_mm = 69.426 }]`"},
       Key::positive("over_balls_uncertainty_mm", "", &I::balls_uncertainty, "0.02",
                     "uncertainty of each dimension over balls"),
       Key::positive("tip_diameter_mm", "d_a", {&I::tip, &MaybeReading<double>::value}, "",
                     "tip diameter; the tip may be worn. Over the tips of an odd number of teeth, "
                     "a calliper reads up to d_a/2 (1 − cos(180°/z)) less than the tip diameter"),
       Key::positive("tip_diameter_uncertainty_mm", "",
                     {&I::tip, &MaybeReading<double>::uncertainty}, "0.02",
                     "uncertainty of the tip diameter, not including wear"),
       Key::positive("root_diameter_mm", "d_f", {&I::root, &MaybeReading<double>::value}, "",
                     "root diameter"),
       Key::positive("root_diameter_uncertainty_mm", "",
                     {&I::root, &MaybeReading<double>::uncertainty}, "0.02",
                     "uncertainty of the root diameter"),
       Key::number("lead_mm", "p_z", KeyRange{.zero = false},
                   {&I::lead, &MaybeReading<double>::value}, "", "lead, > 0 for right hand"),
       Key::positive("lead_uncertainty_mm", "", {&I::lead, &MaybeReading<double>::uncertainty},
                     "2 % of the lead", "uncertainty of the lead"),
       Key::number(
           "helix_angle_deg", "β", KeyRange::between(-89, 89),
           {&I::helix, &MaybeReading<Angle>::value}, "",
           "helix angle at the reference cylinder, > 0 right hand, 0 for straight teeth; an "
           "angle β_a measured at the tip is converted by tan β = tan β_a · d/d_a"),
       Key::positive("helix_angle_uncertainty_deg", "",
                     {&I::helix, &MaybeReading<Angle>::uncertainty}, "0.5",
                     "uncertainty of the helix angle"),
       Key::positive("center_distance_mm", "a", {&I::distance, &MaybeReading<double>::value}, "",
                     "centre distance to the mating gear")
           .with_needs({"mating_teeth"}),
       Key::positive("center_distance_uncertainty_mm", "",
                     {&I::distance, &MaybeReading<double>::uncertainty}, "0.02",
                     "uncertainty of the centre distance"),
       Key::number("mating_teeth", "z", KeyRange{.lo = -1e5, .hi = 1e5, .zero = false},
                   &I::mating_teeth, "",
                   "number of teeth of the mating gear, negative for an internal gear")}};
  return table;
}

const KeyTable& measured_ball_keys() {
  static const KeyTable table{
      "measured_ball",
      "One dimension over two balls, or between two balls for an internal gear",
      {Key::positive("ball_diameter_mm", "D_M", &DiameterReading::tool, kRequired,
                     "diameter of the balls"),
       Key::positive("dimension_mm", "M_dK", &DiameterReading::value, kRequired,
                     "dimension over both balls, or between both balls for an internal gear")}};
  return table;
}

const KeyTable& unknown_gear_keys() {
  static const KeyTable table = [] {
    // An unknown gear has no module. The list still contains the keys of the module, so that the
    // reader can suggest one of them for a misspelled key.
    KeyTable t = gear_keys().only({"teeth", "normal_module_mm", "normal_diametral_pitch_per_in",
                                   "normal_pressure_angle_deg", "helix_angle_deg", "face_width_mm",
                                   "measured"});
    t.name = "unknown_gear";
    t.meaning = "Known values of a gear in addition to its readings";
    return t;
  }();
  return table;
}

}  // namespace gearwright
