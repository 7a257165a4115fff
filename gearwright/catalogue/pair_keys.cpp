#include "gearwright/catalogue/pair_keys.hpp"

namespace gearwright {

const KeyTable& pair_keys() {
  static const KeyTable table{
      "pair",
      "How the two gears are mounted",
      {{.key = "center_distance_mm",
        .symbol = "a",
        .range = KeyRange::positive(),
        .place = &PairInput::center_distance,
        .fallback = "what `mounting` says",
        .meaning = "centre distance",
        .also = {"centre_distance", "distance", "axis_distance", "center", "cd"}},
       {.key = "shaft_angle_deg",
        .symbol = "Σ",
        .range = KeyRange::inside(-180, 180, " (> 0: right hands prevail)"),
        .place = &PairInput::shaft_angle,
        .fallback = "0 where the helices allow it; an error where both have one hand and angle; "
                    "else that of "
                    "the minimum centre distance, with a warning",
        .meaning = "Σ = β_w1 + β_w2, signed: two right hands cross at Σ > 0, two left hands at "
                   "Σ < 0",
        .also = {"axis_angle", "crossing_angle"}},
       {.key = "backlash_mm",
        .symbol = "j_n",
        .range = KeyRange::not_negative(": the teeth would press into each other"),
        .place = &PairInput::backlash,
        .excludes = {"backlash_circumferential_mm", "backlash_deg"},
        .fallback = "what the allowances and the centre distance leave",
        .meaning = "normal backlash: the teeth are thinned for it, instead of by "
                   "`thickness_allowance_mm`",
        .also = {"backlash", "play", "normal_backlash", "jn"}},
       {.key = "backlash_circumferential_mm",
        .symbol = "j_t",
        .range = KeyRange::not_negative(": the teeth would press into each other"),
        .place = &PairInput::backlash_circumferential,
        .excludes = {"backlash_deg"},
        .meaning = "the same as an arc of the working pitch circle of gear 1",
        .also = {"circumferential_backlash", "transverse_backlash", "jt", "jwt"}},
       {.key = "backlash_deg",
        .range = KeyRange::not_negative(": the teeth would press into each other"),
        .place = &PairInput::backlash_angle,
        .meaning = "the same as the angle that gear 1 turns while gear 2 is held",
        .fields = {"backlash_angle"},
        .also = {"angular_backlash", "backlash_angle"}},
       {.key = "backlash_split",
        .range = KeyRange::between(0, 1),
        .place = &PairInput::backlash_split,
        .fallback = "0.5",
        .meaning = "gear 1's share of the thinning; the rest is gear 2's"},
       {.key = "mounting",
        .kind = KeyKind::word,
        .words = {"tight", "extended"},
        .place = &PairInput::mounting,
        .fallback = "\"tight\"",
        .meaning =
            "`\"tight\"`: free of backlash for nominal teeth; `\"extended\"`: a_d + m_n (x1 + "
            "x2), an internal gear a_d − m_n (x1 + x2)"},
       {.key = "shorten_tips",
        .kind = KeyKind::boolean,
        .place = &PairInput::shorten_tips,
        .fallback = "false",
        .meaning = "tips without a given `tip_diameter_mm` are cut back by k m_n, so that the "
                   "clearance of the racks is kept"},
       {.key = "friction_coefficient",
        .symbol = "μ",
        .range = {.lo = 0, .hi = 1, .hi_open = true, .reason = ", usually 0.03 to 0.1"},
        .place = &PairInput::friction_coefficient,
        .fallback = "no efficiency",
        .meaning = "coefficient of friction of the flanks, for the efficiency",
        .also = {"friction"}},
       {.key = "speed_rpm",
        .symbol = "n_1",
        .range = KeyRange::positive(),
        .place = &PairInput::speed_rpm,
        .fallback = "no velocities",
        .meaning = "speed of rotation of gear 1, for the pitch line velocity",
        .also = {"speed", "rpm", "n"}}}};
  return table;
}

}  // namespace gearwright
