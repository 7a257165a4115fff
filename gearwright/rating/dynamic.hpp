// Computes the internal dynamic loads of the mesh to method B of ISO 6336-1, as the dynamic factor.
// Running-in and resonance are taken into account.
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

/// Returns the reduction of a deviation by running-in, µm, as the mean of both materials.
///
/// Formula   ISO 6336-1, 8.3.5, (75) and the following formulas, by kind of material and pitch line
///           velocity v
double running_in(const std::array<Material, 2>& materials, double deviation, double velocity);
/// Returns the tip relief due to running-in, C_ay, µm, as the mean of both materials.
///
/// Formula   ISO 6336-1, 6.5.4, (18)
double running_in_relief(const std::array<Material, 2>& materials);

/// Returns the reduced mass of the mesh per millimetre of face, kg/mm.
///
/// Formula   [T11.4]; ISO 6336-1, 6.5.9, (30): a gear is a ring between the bore and d_m = (d_Fa +
///           d_f)/2. An internal gear is a ring outside d_m; by default its rim has a thickness of
///           2.5 modules
/// Domain    the densities of both materials are known (contract)
double reduced_mass(const RatedPair& pair, const std::array<Material, 2>& materials);

struct DynamicInput {
  double speed = 0.0;                ///< n_1   1/min, of the pinion
  double specific_load = 0.0;        ///< F_t K_A K_γ/b  N/mm
  double c_prime = 0.0;              ///< c'    N/(mm µm)
  double c_gamma_alpha = 0.0;        ///< c_γα  N/(mm µm)
  double reduced_mass = 0.0;         ///< m_red kg/mm
  double pitch_error = 0.0;          ///< f_pb − y_p  µm
  double profile_error = 0.0;        ///< f_fα − y_f  µm
  std::optional<double> tip_relief;  ///< C_a   µm; absent for grade 6 and coarser, where B_k = 1
  double epsilon_gamma = 0.0;
  int teeth = 0;  ///< z_1
};

struct Dynamic {
  Factor n_E1;  ///< resonance speed of the pinion, 1/min
  Factor N;
  Factor K_v;
};

/// Returns N_S, the resonance ratio N at which the main resonance begins. `specific_load` is
/// defined as in DynamicInput.
///
/// Formula   ISO 6336-1, 6.5
double resonance_begin(double specific_load);

/// Formula   [T11.5]…[T11.10]; ISO 6336-1, 6.5: (6), N_S, (13)…(17), (20)…(22)
/// Laws      (1) K_v → 1 as the speed decreases to 0   (2) K_v is continuous at N = 1.15 and 1.5
/// Domain    ε_γ > 1; for a smaller ε_γ the constants of the lowest range are used
Dynamic dynamic_factor(const DynamicInput& in);

// Mesh stiffness: ISO 6336-1, clause 9, method B.
//
//   q'       flexibility of a pair of teeth per face width, (mm µm)/N        c'_th = 1/q'
//   c'       stiffness of a pair of teeth, including gear bodies and basic rack, N/(mm µm)
//   c_γα, c_γβ   mesh stiffness, N/(mm µm)
//   C_M      correction by measurements, 0.8
//   C_R, C_B, E/E_St   corrections for gear body, basic rack and material

/// A gear body with web and rim, which applies to both gears of a pair. Without a RatedBody, both
/// gears are solid discs.
struct RatedBody {
  double web_share = 1.0;    ///< b_s/b, 0.2 … 1.2
  double rim_modules = 5.0;  ///< s_R/m_n, ≥ 1
};

struct Stiffness {
  Factor c_th;           ///< c'_th  N/(mm µm)
  Factor c_prime;        ///< c'
  Factor c_gamma_alpha;  ///< c_γα
  Factor c_gamma_beta;   ///< c_γβ
  double C_R, C_B;
  bool in_range;  ///< true if x_1 ≥ x_2 and −0.5 ≤ x_1 + x_2 ≤ 2, the range of the formula for q'
};
/// Returns the gear body whose web and rim have these thicknesses on the drawing, mm.
inline RatedBody rated_body(const RatedPair& pair, double web, double rim) {
  return {web / pair.face_width, rim / pair.normal_module};
}

/// Returns the stiffness of a mesh. `specific_load` is F_t K_A K_γ/b in N/mm. A load below 100 N/mm
/// reduces the stiffness. `elasticity` is E/E_St.
///
/// Formula   [T11.2], [T11.3]; ISO 6336-1, clause 9; q' with z_n = z/(cos² β_b cos β), and with
///           1/z_n2 = 0 for an internal gear
Stiffness mesh_stiffness(const RatedPair& pair, double specific_load, double elasticity,
                         const std::optional<RatedBody>& body);

// Material correction of formulas that ISO 6336-1 gives for two steel gears.

/// Returns E/E_St of two gears with the moduli of elasticity e1 and e2, MPa.
///
/// Formula   ISO 6336-1, clause 9: E = 2 E_1 E_2/(E_1 + E_2), E_St = 206 000 N/mm²
inline double relative_elasticity(double e1, double e2) {
  constexpr double kSteel = 206000.0;
  return 2 * e1 * e2 / (e1 + e2) / kSteel;
}

}  // namespace gearwright
