// Computes the load distribution factors along the face (K_Hβ, K_Fβ) and between the tooth pairs in
// mesh (K_Hα, K_Fα).
//
//   f_sh, f_ma   misalignment from shaft and pinion deflection, and from manufacture, µm
//   F_βx, F_βy   equivalent misalignment before and after running-in, µm
//   F_m          mean transverse force F_t K_A K_γ K_v, N
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/compliance/shaft.hpp"
#include "gearwright/rating/factor.hpp"
#include "gearwright/rating/material.hpp"
#include "gearwright/rating/rated_pair.hpp"

namespace gearwright {

/// The arrangements of pinion, bearings and torque in the figure of the constant K'.
/// [ISO 6336-1, figure 13]
enum class PinionArrangement { a, b, c, d, e };

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
  std::optional<Factor> f_sh, F_betax, F_betay;  ///< µm, present if K_Hβ is computed from f_sh
  bool offset_in_range = true;                   ///< true if s/l is at most the limit of the figure
};

/// Computes K_Hβ without helix modification, from the mounting.
///
/// Formula   [T11.11]…[T11.13]; ISO 6336-1, 7.5 with B_1 = B_2 = 1
/// Law       the two branches are equal at F_βy c_γβ/(2 F_m/b) = 1
FaceLoad face_load(const RatedPair& pair, const PinionMounting& mounting,
                   const std::array<Material, 2>& materials, double mean_load, double c_gamma_beta,
                   const std::array<double, 2>& f_Hbeta, double velocity);

/// Computes K_Hβ without helix modification, from f_sh and f_ma, µm.
///
/// Formula   [T11.12], [T11.13]
FaceLoad face_load(const Factor& f_sh, double f_ma, const std::array<Material, 2>& materials,
                   double mean_load, double c_gamma_beta, const std::array<double, 2>& f_Hbeta,
                   double velocity);

/// Computes K_Fβ from K_Hβ.
///
/// Formula   [T11.14]; ISO 6336-1, 7.6: K_Fβ = K_Hβ^(N_F). N_F depends on the lesser b/h of the two
///           gears. If this b/h is less than 3, N_F is computed with 3
Factor face_load_root(const RatedPair& pair, double K_Hbeta);

struct TransverseLoad {
  Factor K_Halpha, K_Falpha;
};

/// Computes K_Hα and K_Fα. `deviation` is max(f_pb, f_fα) − y_α, µm, and `load`, N/mm, is
/// F_t K_A K_γ K_v K_Hβ/b.
///
/// Formula   [T11.15]; ISO 6336-1, 8.3, with both branches of ε_γ and both limits
TransverseLoad transverse_load(const RatedPair& pair, double c_gamma_alpha, double deviation,
                               double load, double Z_epsilon);

// Deviation of the flanks along the face due to the deflections of both shafts.
//
//   F_t        transverse force at the reference cylinder of the pinion, N
//   F_bt       force in the transverse plane of action, N       T_i   torque on gear i, N mm
//   w_i, φ_i   bending of shaft i along the line of action, and twist over the face
//   f(z)       Σ (w_i + r_bi φ_i), displacement of the flanks at z, µm
//   f_sh       greatest minus least f over the common face, µm
//                                                          theory: docs/theory/11-rating.md
//
// The bending of a shaft is computed with the given diameters of the shaft. The twist over the face
// is computed for a solid cylinder with the root diameter.

/// The shafts of gear 1 and gear 2 of the spec. A gear without a shaft is rigid.
struct MeshShafts {
  std::array<std::optional<Shaft>, 2> of;
  double hand1 = 0.0;         ///< sign of β of gear 1, > 0 for right hand
  bool gear2_drives = false;  ///< true if gear 2 drives, so that the trailing flanks carry the load

  bool any() const { return of[0] || of[1]; }
};

/// Number of equally spaced points of the common face, including both ends, at which f is computed.
constexpr int kShaftPoints = 257;
/// Returns f under F_t at kShaftPoints points, in the order of ascending z.
///
/// Formula   [T11.48]…[T11.52]
/// Domain    a gear with a shaft is external (contract)
/// Laws      (1) f is linear in F_t
///           (2) if the shafts are mirrored at z = 0 and the hands are exchanged, the values of f
///               are the same in reverse order
std::vector<double> shaft_deviation(const RatedPair& pair, const MeshShafts& shafts, double F_t);

/// Returns f_sh under F_t, µm.
double shaft_misalignment(const RatedPair& pair, const MeshShafts& shafts, double F_t);

}  // namespace gearwright
