// Internal dynamic loads of the mesh: running-in, resonance and the dynamic factor, method B.
//
//   m_red    reduced mass of the pair per face width, kg/mm
//   n_E1     resonance speed of the pinion, 1/min           N = n_1/n_E1
//   f_pb, f_fα   base pitch and profile form deviation, µm
//   y_p, y_f     reduction of these deviations by running-in, µm
//   B_p, B_f, B_k   deviations and tip relief, relative to the deflection of the loaded tooth
#pragma once

#include <array>
#include <optional>

#include "gearwright/rating/factor.hpp"
#include "gearwright/rating/material.hpp"
#include "gearwright/rating/rated_pair.hpp"

namespace gearwright {

/// Reduction of a deviation by running-in, µm, as the mean of both materials.
///
/// Formula   ISO 6336-1, 8.3.5, (75) and the following formulas, by kind of material and pitch line
///           velocity v
double running_in(const std::array<Material, 2>& materials, double deviation, double velocity);
/// Tip relief due to running-in, C_ay, µm, as the mean of both materials.
///
/// Formula   ISO 6336-1, 6.5.4, (18)
double running_in_relief(const std::array<Material, 2>& materials);

/// Reduced mass of the mesh per millimetre of face, kg/mm.
///
/// Formula   [T11.4]; ISO 6336-1, 6.5.9, (30): a gear is a ring between the bore and
///           d_m = (d_a + d_f)/2. An internal gear is a ring outside d_m; by default its rim has a
///           thickness of 2.5 modules
double reduced_mass(const RatedPair& pair, const std::array<Material, 2>& materials);

struct DynamicInput {
  double speed = 0.0;                ///< n_1   1/min, of the pinion
  double specific_load = 0.0;        ///< F_t K_A K_γ/b  N/mm
  double c_prime = 0.0;              ///< c'    N/(mm µm)
  double c_gamma_alpha = 0.0;        ///< c_γα  N/(mm µm)
  double reduced_mass = 0.0;         ///< m_red kg/mm
  double pitch_error = 0.0;          ///< f_pb − y_p  µm
  double profile_error = 0.0;        ///< f_fα − y_f  µm
  std::optional<double> tip_relief;  ///< C_a   µm; none for grade 6 and coarser, so that B_k = 1
  double epsilon_gamma = 0.0;
  int teeth = 0;  ///< z_1
};

struct Dynamic {
  Factor n_E1;  ///< 1/min
  Factor N;
  Factor K_v;
};

/// Resonance speed, resonance ratio and dynamic factor.
///
/// Formula   [T11.5]…[T11.10]; ISO 6336-1, 6.5: (6), N_S, (13)…(17), (20)…(22)
/// Laws      (1) K_v → 1 as the speed decreases to 0   (2) K_v is continuous at N = 1.15 and 1.5
/// Domain    ε_γ > 1; for a smaller ε_γ the constants of the lowest range are used
Dynamic dynamic_factor(const DynamicInput& in);

}  // namespace gearwright
