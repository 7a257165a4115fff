#include "gearwright/catalogue/inspection_keys.hpp"

namespace gearwright {

const KeyTable& measure_keys() {
  static const KeyTable table{
      "measure",
      "Positions and tools of the measurements; only the verb measure reads this table",
      {Key::positive("chord_diameter_mm", "", &MeasureInput::chord_diameter,
                     "the reference diameter, or the middle of the usable flank if that diameter "
                     "lies outside it",
                     "contact diameter of the calliper's jaws, on the usable flank; the tooth "
                     "thickness refers to it too"),
       Key::number("span_teeth", "k", KeyRange::between(1, 1e5), &MeasureInput::span_teeth,
                   "the number whose contacts are nearest to the V circle d + 2 x m_n",
                   "teeth between the anvils of a span measurement; spaces of an internal gear")
           .with_also({"span", "teeth", "k", "number_of_teeth_spanned"}),
       Key::positive("ball_diameter_mm", "D_M", &MeasureInput::ball_diameter,
                     "the standard size nearest to the one that touches at the V circle",
                     "diameter of the measuring balls")
           .with_also({"ball", "balls", "dm"}),
       Key::positive("pin_diameter_mm", "D_M", &MeasureInput::pin_diameter, "that of the balls",
                     "diameter of the measuring pins (rollers, wires)")
           .with_also({"pin", "pins", "wire", "roller"})}};
  return table;
}

const KeyTable& tolerance_keys() {
  static const KeyTable table{
      "tolerance",
      "The accuracy grade of the flanks and the limits of the tooth thickness",
      {Key::number(
           "quality", "", KeyRange::between(0, 12, ", the flank tolerance classes of ISO 1328-1"),
           &ToleranceInput::quality, "no tolerances", "flank tolerance class (grade) of ISO 1328-1")
           .with_also({"grade", "class", "accuracy_grade"}),
       Key::word("edition", {"ISO 1328:2013", "ISO 1328:1995"}, &ToleranceInput::edition,
                 "\"ISO 1328:2013\"", "edition of the standard that the tolerances follow")
           .with_also({"standard"}),
       Key::text("thickness_series", &ToleranceInput::series, "",
                 "allowance and tolerance of DIN 3967, `\"cd25\"`: series a, ab, b, bc, c, cd, d, "
                 "e, f, g or h, and 21 to 30; instead of `thickness_allowance_mm`")
           .with_fields({"series"})
           .with_also({"din3967", "series"}),
       Key::number("span_mm", "", {}, &ToleranceInput::span, "",
                   "least and greatest span over `span_teeth` of `[gearN.measure]`: the allowances "
                   "follow")
           .with_list(kLowerAndUpper)
           .with_excludes({"thickness_series"}),
       Key::number("over_balls_mm", "", {}, &ToleranceInput::over_balls, "",
                   "least and greatest dimension over (internal: between) balls of "
                   "`ball_diameter_mm` of `[gearN.measure]`: the allowances follow")
           .with_list(kLowerAndUpper)
           .with_excludes({"thickness_series", "span_mm"}),
       Key::number("tip_diameter_deviations_mm", "A_da", {}, &ToleranceInput::tip_deviations,
                   "the tip diameter has no tolerance",
                   "lower and upper deviation of the tip diameter; every number that depends on it "
                   "has an interval")
           .with_list(kLowerAndUpper)
           .with_fields({"tip_deviations"})
           .with_also({"a_da", "tip_diameter_tolerance", "tip_tolerance", "tip_allowance"})}};
  return table;
}

}  // namespace gearwright
