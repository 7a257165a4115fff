// Two gears of plane triangles under load: the load sharing of tooth pairs on their line of action.
//
//   ρ   distance from the base circle along the line of action      external pair   ρ2 = T − ρ1
//   T   a sin α_w                                                    internal pair   ρ2 = T + ρ1
//
// plane_teeth provides the deflection of both gears, and Hertz's formula the width of each contact.
// A wider strip deflects less, by 2(1 − ν²)/(πE) times the logarithm of the width. Lengths are in
// modules.
#pragma once

#include <vector>

#include "tests/oracle/plane_teeth.hpp"

namespace gearwright::oracle {

struct PlanePair {
  PlaneGear one, two;
  double base_1 = 0.0, base_2 = 0.0;        ///< base radii
  double line = 0.0;                        ///< T
  double first = 0.0, last = 0.0;           ///< ρ1 at the start and at the end of the path
  std::array<double, 2> modulus{1.0, 1.0};  ///< Young's moduli of both gears, relative to E
};

struct PlaneShare {
  double approach = 0.0;         ///< E·u/F′, along the line of action
  std::vector<double> share;     ///< shares of the tooth pairs; the pair nearest to its exit is the
                                 ///< last
  std::array<double, 2> root{};  ///< greatest principal stress at the roots, σ·m/F′
};

/// `rho` is ρ1 of the pair that entered last; `load` is F′/(E m).
PlaneShare plane_share(const PlanePair& pair, double rho, double load, double fineness);

}  // namespace gearwright::oracle
