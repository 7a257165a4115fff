// Deviation of the flanks along the face, due to the deflections of both shafts under the mesh force.
//
//   F_t        transverse force at the reference cylinder of the pinion, N
//   F_bt       force in the transverse plane of action, N       T_i   torque on gear i, N mm
//   w_i, φ_i   bending of shaft i along the line of action, and twist over the face
//   f(z)       Σ (w_i + r_bi φ_i), displacement of the flanks at z, µm
//   f_sh       greatest minus least f over the common face, µm
//                                                          theory: docs/theory/11-rating.md
//
// The bending of a shaft is computed with its given diameters, and the twist over the face with a solid
// body of the root diameter.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/compliance/shaft.hpp"
#include "gearwright/rating/rated_pair.hpp"

namespace gearwright {

/// The shafts of gear 1 and gear 2 of the spec. A gear without a shaft is rigid.
struct MeshShafts {
  std::array<std::optional<Shaft>, 2> of;
  double hand1 = 0.0;         ///< sign of β of gear 1, > 0 for right hand
  bool gear2_drives = false;  ///< true if gear 2 drives, so that the trailing flanks carry the load
                              /// True if at least one gear has a shaft.
  bool any() const { return of[0] || of[1]; }
};

/// Number of equally spaced points of the common face, including both ends, at which f is computed.
constexpr int kShaftPoints = 257;
/// f at kShaftPoints points, by ascending z, under F_t.
///
/// Formula   [T11.48]…[T11.52]
/// Domain    a gear with a shaft is external (contract)
/// Laws      (1) f is linear in F_t
///           (2) if the gears are mirrored at z = 0, with the other hand, f is reversed
std::vector<double> shaft_deviation(const RatedPair& pair, const MeshShafts& shafts, double F_t);

/// f_sh under F_t, µm.
double shaft_misalignment(const RatedPair& pair, const MeshShafts& shafts, double F_t);

}  // namespace gearwright
