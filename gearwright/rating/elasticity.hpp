// Material correction of formulas that ISO 6336-1 gives for two steel gears.
#pragma once

namespace gearwright {

/// E/E_St of two gears with the moduli of elasticity e1 and e2, MPa.
///
/// Formula   ISO 6336-1, clause 9: E = 2 E_1 E_2/(E_1 + E_2), E_St = 206 000 N/mm²
inline double relative_elasticity(double e1, double e2) {
  constexpr double kSteel = 206000.0;
  return 2 * e1 * e2 / (e1 + e2) / kSteel;
}

}  // namespace gearwright
