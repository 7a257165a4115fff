#include "gearwright/catalogue/inspection_keys.hpp"

namespace gearwright {

const KeyTable& measure_keys() {
  static const KeyTable table{
      "measure",
      "Where and how the gear is measured; only the verb measure reads it",
      {{.key = "chord_diameter_mm",
        .range = KeyRange::positive(),
        .place = &MeasureInput::chord_diameter,
        .fallback = "the reference diameter, or the middle of the usable flank where that lies "
                    "off it",
        .meaning = "where the calliper's jaws touch, on the usable flank; the tooth thickness is "
                   "given there too"},
       {.key = "span_teeth",
        .symbol = "k",
        .kind = KeyKind::whole,
        .range = KeyRange::between(1, 1e5),
        .place = &MeasureInput::span_teeth,
        .fallback = "the number that touches nearest to the V circle d + 2 x m_n",
        .meaning = "teeth between the anvils of a span measurement; spaces of an internal gear",
        .also = {"span", "teeth", "k", "number_of_teeth_spanned"}},
       {.key = "ball_diameter_mm",
        .symbol = "D_M",
        .range = KeyRange::positive(),
        .place = &MeasureInput::ball_diameter,
        .fallback = "the standard size nearest to the one that touches at the V circle",
        .meaning = "diameter of the measuring balls",
        .also = {"ball", "balls", "dm"}},
       {.key = "pin_diameter_mm",
        .symbol = "D_M",
        .range = KeyRange::positive(),
        .place = &MeasureInput::pin_diameter,
        .fallback = "that of the balls",
        .meaning = "diameter of the measuring pins (rollers, wires)",
        .also = {"pin", "pins", "wire", "roller"}}}};
  return table;
}

const KeyTable& tolerance_keys() {
  static const KeyTable table{
      "tolerance",
      "The grade of the flanks, and how thick the teeth may be",
      {{.key = "quality",
        .kind = KeyKind::whole,
        .range = KeyRange::between(0, 12, ", the flank tolerance classes of ISO 1328-1"),
        .place = &ToleranceInput::quality,
        .fallback = "no tolerances",
        .meaning = "flank tolerance class (grade) of ISO 1328-1",
        .also = {"grade", "class", "accuracy_grade"}},
       {.key = "edition",
        .kind = KeyKind::word,
        .words = {"ISO 1328:2013", "ISO 1328:1995"},
        .place = &ToleranceInput::edition,
        .fallback = "\"ISO 1328:2013\"",
        .meaning = "edition of the standard that the tolerances follow",
        .also = {"standard"}},
       {.key = "thickness_series",
        .kind = KeyKind::text,
        .place = &ToleranceInput::series,
        .meaning =
            "allowance and tolerance of DIN 3967, `\"cd25\"`: series a, ab, b, bc, c, cd, d, "
            "e, f, g or h, and 21 to 30; instead of `thickness_allowance_mm`",
        .fields = {"series"},
        .also = {"din3967", "series"}},
       {.key = "span_mm",
        .list = KeyList{2, 2},
        .excludes = {"thickness_series"},
        .meaning = "least and greatest span over `span_teeth` of `[gearN.measure]`: the allowances "
                   "follow"},
       {.key = "over_balls_mm",
        .list = KeyList{2, 2},
        .excludes = {"thickness_series", "span_mm"},
        .meaning = "least and greatest dimension over (internal: between) balls of "
                   "`ball_diameter_mm` of `[gearN.measure]`: the allowances follow"},
       {.key = "tip_diameter_deviations_mm",
        .symbol = "A_da",
        .list = KeyList{2, 2},
        .fallback = "the tip diameter has no tolerance",
        .meaning = "lower and upper deviation of the tip diameter; every number that depends on it "
                   "has an interval",
        .fields = {"tip_deviations"},
        .also = {"a_da", "tip_diameter_tolerance", "tip_tolerance", "tip_allowance"}}}};
  return table;
}

}  // namespace gearwright
