#include "gearwright/catalogue/measured_keys.hpp"

#include <string_view>

#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/inspection/identify.hpp"

namespace gearwright {

namespace {

template <class F>
KeyPlace reading(F reach) {
  return KeyPlace::within<IdentifyProblem>(reach);
}

Key uncertainty(std::string_view key, KeyPlace place, std::string_view fallback,
                std::string_view meaning) {
  return {.key = key,
          .range = KeyRange::positive(),
          .place = std::move(place),
          .fallback = fallback,
          .meaning = meaning};
}

}  // namespace

const KeyTable& measured_keys() {
  static const KeyTable table{
      "measured",
      "Readings of an unknown gear, for the verb identify; an uncertainty is that of 95 %",
      {{.key = "span_mm",
        .symbol = "W_k",
        .kind = KeyKind::any,
        .form = "a table of readings by the number of teeth: { 3 = 19.751, 4 = 27.131 }",
        .meaning = "spans over k teeth (internal: spaces), `{ 3 = 19.751, 4 = 27.131 }`"},
       uncertainty("span_uncertainty_mm", &IdentifyProblem::span_uncertainty, "0.02",
                   "of each span"),
       {.key = "over_balls_mm",
        .symbol = "M_dK",
        .kind = KeyKind::table,
        .list = KeyList{1, kMostBallReadings},
        .tables = {measured_ball_keys},
        .meaning = "over two balls (internal: between them), "
                   "`[{ ball_diameter_mm = 5, dimension_mm = 69.426 }]`"},
       uncertainty("over_balls_uncertainty_mm", &IdentifyProblem::balls_uncertainty, "0.02",
                   "of each dimension over balls"),
       {.key = "tip_diameter_mm",
        .symbol = "d_a",
        .range = KeyRange::positive(),
        .place = reading([](auto& p) -> auto& { return p.tip.value; }),
        .meaning = "tip diameter; the tip may be worn"},
       uncertainty("tip_diameter_uncertainty_mm",
                   reading([](auto& p) -> auto& { return p.tip.uncertainty; }), "0.02",
                   "of the tip diameter, without wear"),
       {.key = "root_diameter_mm",
        .symbol = "d_f",
        .range = KeyRange::positive(),
        .place = reading([](auto& p) -> auto& { return p.root.value; }),
        .meaning = "root diameter"},
       uncertainty("root_diameter_uncertainty_mm",
                   reading([](auto& p) -> auto& { return p.root.uncertainty; }), "0.02",
                   "of the root diameter"),
       {.key = "lead_mm",
        .symbol = "p_z",
        .range = {.zero = false},
        .place = reading([](auto& p) -> auto& { return p.lead.value; }),
        .meaning = "lead, > 0 right hand"},
       uncertainty("lead_uncertainty_mm",
                   reading([](auto& p) -> auto& { return p.lead.uncertainty; }), "2 % of the lead",
                   "of the lead"),
       {.key = "helix_angle_deg",
        .symbol = "β",
        .range = KeyRange::between(-89, 89),
        .place = reading([](auto& p) -> auto& { return p.helix.value; }),
        .meaning = "helix angle at the reference cylinder, > 0 right hand; 0: the teeth "
                   "are straight"},
       uncertainty("helix_angle_uncertainty_deg",
                   reading([](auto& p) -> auto& { return p.helix.uncertainty; }), "0.5",
                   "of the helix angle"),
       {.key = "center_distance_mm",
        .symbol = "a",
        .range = KeyRange::positive(),
        .place = reading([](auto& p) -> auto& { return p.distance.value; }),
        .needs = {"mating_teeth"},
        .meaning = "centre distance to the mating gear"},
       uncertainty("center_distance_uncertainty_mm",
                   reading([](auto& p) -> auto& { return p.distance.uncertainty; }), "0.02",
                   "of the centre distance"),
       {.key = "mating_teeth",
        .symbol = "z",
        .kind = KeyKind::whole,
        .range = {.lo = -1e5, .hi = 1e5, .zero = false},
        .place = &IdentifyProblem::mating_teeth,
        .meaning = "number of teeth of the mating gear, negative if internal"}}};
  return table;
}

const KeyTable& measured_ball_keys() {
  static const KeyTable table{"measured_ball",
                              "One dimension over or between two balls",
                              {{.key = "ball_diameter_mm",
                                .symbol = "D_M",
                                .range = KeyRange::positive(),
                                .place = &DiameterReading::tool,
                                .required = true,
                                .meaning = "diameter of the balls"},
                               {.key = "dimension_mm",
                                .symbol = "M_dK",
                                .range = KeyRange::positive(),
                                .place = &DiameterReading::value,
                                .required = true,
                                .meaning = "over both, or between them in an internal gear"}}};
  return table;
}

const KeyTable& unknown_gear_keys() {
  static const KeyTable table = [] {
    KeyTable t{"unknown_gear", "What may be known of a gear beside its readings", {}};
    // The module is never there, but where people misspell it.
    for (const char* key :
         {"teeth", "normal_module_mm", "normal_diametral_pitch_per_in", "normal_pressure_angle_deg",
          "helix_angle_deg", "face_width_mm", "measured"})
      t.keys.push_back(*gear_keys().find(key));
    return t;
  }();
  return table;
}

}  // namespace gearwright
