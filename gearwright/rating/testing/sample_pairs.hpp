// Pairs of published ratings, as their reports print them.
#pragma once

#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/pair/pair.hpp"
#include "gearwright/rating/rating.hpp"

namespace gearwright::testing {

struct PrintedGear {
  int teeth;
  double shift, tip_diameter;  ///< x; d_a mm, or 0 for the tip diameter that the rack gives
};

inline CylindricalSpec printed_spec(const PrintedGear& g, double module, double beta_deg,
                                    double face, const StraightRack& rack) {
  CylindricalSpec s = testing::plain_spec(
      {.teeth = g.teeth, .module = module, .beta_deg = beta_deg, .x = g.shift, .face_width = face});
  if (g.tip_diameter > 0.0) s.tip_diameter = g.tip_diameter;
  s.rack = rack;
  return s;
}

inline RatedPair printed_pair(const PrintedGear& g1, const PrintedGear& g2, double module,
                              double beta_deg, double face, double distance,
                              const StraightRack& rack, std::array<double, 2> bore = {}) {
  const double mate = g2.teeth < 0 ? beta_deg : -beta_deg;
  Gear first = make_gear(printed_spec(g1, module, beta_deg, face, rack)).value();
  Gear second = make_gear(printed_spec(g2, module, mate, face, rack)).value();
  if (bore[0] > 0.0) first.bore = Bore{bore[0]};
  if (bore[1] > 0.0) second.bore = Bore{bore[1]};
  PairSpec place;
  if (distance > 0.0) place.center_distance = distance;
  return rated_pair(*mount(std::move(first), std::move(second), place)).value();
}

inline Material case_hardened() { return *material_named("18CrNiMo7-6"); }

/// KISSsoft 03/2017, ISO 6336:2006 method B: the third stage of a wind turbine's gearbox.
inline RatedPair helical_24_95() {
  return printed_pair({24, 0.48, 380.747}, {95, 0.6691, 1395.376}, 14, 10, 360, 861,
                      *iso53_rack("ISO53-A"), {179.1, 1193.32});
}
inline RatingInput helical_24_95_load() {
  RatingInput in;
  in.torque = 40953.0;
  in.speed = 1165.9;
  in.application_factor = 1.25;
  in.face_load_factor = 1.15;
  in.life_h = 175200;
  in.viscosity = 220;
  in.quality = {6, 6};
  in.flank_roughness = {4.8, 4.8};
  in.root_roughness = {20, 20};
  in.body = RatedBody{0.25, 5};
  in.materials = {case_hardened(), case_hardened()};
  return in;
}

}  // namespace gearwright::testing
