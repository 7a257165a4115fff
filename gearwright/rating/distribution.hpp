// Load distribution factors: along the face (K_Hβ, K_Fβ) and between the tooth pairs in mesh (K_Hα,
// K_Fα).
//
//   f_sh, f_ma   misalignment from shaft and pinion deflection, and from manufacture, µm
//   F_βx, F_βy   equivalent misalignment before and after running-in, µm
//   F_m          mean transverse force F_t K_A K_γ K_v, N
#pragma once

#include <optional>

#include "gearwright/rating/factor.hpp"
#include "gearwright/rating/material.hpp"
#include "gearwright/rating/rated_pair.hpp"

namespace gearwright {

/// The arrangements of pinion, bearings and torque in the figure of the constant K'.
/// [ISO 6336-1, figure 13]
enum class PinionArrangement { a, b, c, d, e };

/// The position of the pinion on its shaft.
struct PinionMounting {
  double bearing_span = 0.0;    ///< l    mm
  double offset = 0.0;          ///< s    mm, from the middle of the bearings
  double shaft_diameter = 0.0;  ///< d_sh mm
  PinionArrangement arrangement = PinionArrangement::a;
  bool stiffening = true;  ///< true if the pinion is integral with its shaft or shrunk onto it
  std::optional<double> manufacture;  ///< f_ma  µm; by default the root sum square of both helix
                                      ///< slope tolerances
};

struct FaceLoad {
  Factor K_Hbeta;
  std::optional<Factor> f_sh, F_betax, F_betay;  ///< µm, if the factor follows from the mounting
  bool offset_in_range = true;                   ///< true if s/l is below the limit of the figure
};

/// Reduction of the misalignment f by running-in, µm, as the mean of both materials.
///
/// Formula   ISO 6336-1, 7.5.2.4, by kind of material and pitch line velocity
double running_in_misalignment(const std::array<Material, 2>& materials, double f, double velocity);

/// K_Hβ without helix modification, from the mounting.
///
/// Formula   [T11.11]…[T11.13]; ISO 6336-1, 7.5 with B_1 = B_2 = 1
/// Law       the two branches are equal at F_βy c_γβ/(2 F_m/b) = 1
FaceLoad face_load(const RatedPair& pair, const PinionMounting& mounting,
                   const std::array<Material, 2>& materials, double mean_load, double c_gamma_beta,
                   const std::array<double, 2>& f_Hbeta, double velocity);

/// K_Hβ without helix modification, from f_sh and f_ma, µm.
///
/// Formula   [T11.12], [T11.13]
FaceLoad face_load(const Factor& f_sh, double f_ma, const std::array<Material, 2>& materials,
                   double mean_load, double c_gamma_beta, const std::array<double, 2>& f_Hbeta,
                   double velocity);

/// K_Fβ from K_Hβ.
///
/// Formula   [T11.14]; ISO 6336-1, 7.6: K_Hβ^(N_F), where N_F follows from the lesser b/h, at least 3
Factor face_load_root(const RatedPair& pair, double K_Hbeta);

struct TransverseLoad {
  Factor K_Halpha, K_Falpha;
};

/// K_Hα and K_Fα. `deviation` is max(f_pb, f_fα) − y_α, µm, and `load` is F_t K_A K_γ K_v K_Hβ/b, N/mm.
///
/// Formula   [T11.15]; ISO 6336-1, 8.3, with both branches of ε_γ and both limits
TransverseLoad transverse_load(const RatedPair& pair, double c_gamma_alpha, double deviation,
                               double load, double Z_epsilon);

}  // namespace gearwright
