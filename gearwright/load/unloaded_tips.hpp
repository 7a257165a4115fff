// Computes the least tip reliefs with which the tips carry no load at both ends of contact.
//
//   C_i   mm, relief at the tip of gear i, normal to the flank        Θ, w, g   as [T12.2]
//   s     mm, normal distance that remains under load between a tip and its mating flank
//   ρ_1   mm, radius of curvature of flank 1, as the coordinate along the path of contact
//
// Under load, the gears approach each other. Without relief, a tooth pair would therefore overlap
// (s < 0) at both ends of the path of contact. The overlap would be at the tip of gear 2 where the
// tooth pair enters the mesh, and at the tip of gear 1 where it leaves the mesh. The reliefs are
// computed from the solution of the complementarity problem. If a tip carries no load, its relief
// is too great by about s.
//                                     theory: docs/theory/12-loaded-contact.md, [T12.27]
#pragma once

#include <array>

#include "gearwright/base/result.hpp"
#include "gearwright/contact/contact_setup.hpp"
#include "gearwright/load/pair_compliance.hpp"

namespace gearwright {

/// The ends of the path of contact and the starts of the tip reliefs, for a pair on parallel axes.
struct TipPath {
  double begin, end;                       ///< ρ_1 of the first and the last contact, mm
  std::array<double, 2> start_diameter{};  ///< where the tip relief of each gear starts, mm
};

struct UnloadedTips {
  std::array<double, 2> amount{};  ///< C_i  mm
  /// False if a tip carries load with the greatest relief that is tried, a fortieth of the module,
  /// or if the forces do not converge with this relief.
  std::array<bool, 2> unloaded{true, true};
};

/// Computes the least reliefs of the pair of `setup` under the greatest torque of the request.
/// The errors, deflections and helix modifications of the pair are included. The profile
/// modifications and topographies of the pair are ignored, because the reliefs replace them.
/// Form waves are also ignored.
///
/// Formula   [T12.27]
/// Domain    involute teeth with line contact; `compliance` belongs to the gears of `setup`; at
///           least one torque (contract)
/// Accuracy  the amounts exceed the least possible amounts by at most 0.005 µm. If `unloaded` is
///           false, the amount is the greatest relief that is tried
/// Errors    `gearN.modifications.tip_relief.reach` as make_removal_field
/// Laws      for aligned gears:
///           (1) if the gears are exchanged, the amounts are exchanged
///           (2) the amounts grow with the torque
Result<UnloadedTips> unloaded_tips(const ContactSetup& setup, const TipPath& path,
                                   const PairCompliance& compliance, const LoadRequest& request,
                                   bool gear2_drives);

}  // namespace gearwright
