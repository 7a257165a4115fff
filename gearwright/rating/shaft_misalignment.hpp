// Deviation of the flanks along the face from the deflections of both shafts under the mesh force.
//
//   F_t        transverse force at the reference cylinder of the pinion, N
//   F_bt       force in the transverse plane of action, N       T_i   torque on gear i, N mm
//   w_i, φ_i   bending of shaft i along the line of action, and twist over the face
//   f(z)       Σ (w_i + r_bi φ_i), µm: by how much the flanks yield at z
//   f_sh       greatest less least f over the common face, µm
//
// Shafts bend with the diameters that are given. Over the face the torque passes through a solid body
// of the root diameter.
//                                                          theory: docs/theory/11-rating.md
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/compliance/shaft.hpp"
#include "gearwright/rating/rated_pair.hpp"

namespace gearwright {

/// The shafts of gear 1 and gear 2 of the spec. A gear without a shaft does not yield.
struct MeshShafts {
  std::array<std::optional<Shaft>, 2> of;
  double hand1 = 0.0;         ///< sign of β of gear 1, > 0 right hand
  bool gear2_drives = false;  ///< true: gear 2 pushes, and the non-working flanks carry

  /// True if one of the gears has a shaft.
  bool any() const { return of[0] || of[1]; }
};

/// Points of the common face at which f is computed, ends included, equally spaced.
constexpr int kShaftPoints = 257;

/// f at kShaftPoints, from −z on, under F_t.
///
/// Formula   [T11.48]…[T11.52]
/// Domain    a gear with a shaft is external (contract)
/// Laws      (1) linear in F_t    (2) mirrored at z = 0, with the other hand: the same, reversed
std::vector<double> shaft_deviation(const RatedPair& pair, const MeshShafts& shafts, double F_t);

/// f_sh under F_t, µm.
double shaft_misalignment(const RatedPair& pair, const MeshShafts& shafts, double F_t);

}  // namespace gearwright
