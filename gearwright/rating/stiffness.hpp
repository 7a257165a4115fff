// Mesh stiffness: ISO 6336-1, clause 9, method B.
//
//   q'       flexibility of a pair of teeth per face width, (mm µm)/N        c'_th = 1/q'
//   c'       stiffness of a pair of teeth, including gear bodies and basic rack, N/(mm µm)
//   c_γα, c_γβ   mesh stiffness, N/(mm µm)
//   C_M      correction by measurements, 0.8
//   C_R, C_B, E/E_St   corrections for gear body, basic rack and material
#pragma once

#include <optional>

#include "gearwright/rating/factor.hpp"
#include "gearwright/rating/rated_pair.hpp"

namespace gearwright {

/// A gear body with web and rim. Without it, the body is a solid disc.
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
/// The body with the dimensions of web and rim from the drawing, mm.
inline RatedBody rated_body(const RatedPair& pair, double web, double rim) {
  return {web / pair.face_width, rim / pair.normal_module};
}

/// The stiffness of a mesh. `specific_load` is F_t K_A/b in N/mm; below 100 N/mm the stiffness
/// decreases. `elasticity` is E/E_St.
///
/// Formula   [T11.2], [T11.3]; ISO 6336-1, clause 9; q' with z_n = z/(cos² β_b cos β), and with
///           1/z_n2 = 0 for an internal gear
Stiffness mesh_stiffness(const RatedPair& pair, double specific_load, double elasticity,
                         const std::optional<RatedBody>& body);

}  // namespace gearwright
