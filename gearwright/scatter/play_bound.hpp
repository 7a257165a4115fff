// Computes a lower bound of the least play over all members of a family.
//
//   T         field of one flank at a fixed place (contact/gap_field.hpp)     Λ   bound of −∂²T/∂x²
//   δ_t       displacement of a place across the plane of action, mm
//   ρ, r_b2   least radius of curvature of the touching flanks, base radius of gear 2, mm
//
// T + ½Λ|x|² is convex in the deviations x. TE of a flank is the greatest T. The play is minus the
// sum of TE of the working and the non-working flank. The play is therefore concave, except for a
// term of second order, and except for this term it is least at a corner.
//                                    theory: docs/theory/14-scatter.md, [T14.29]
// Internal to scatter/.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/scatter/scatter.hpp"

namespace gearwright {

/// Returns a lower bound of the least play of all members at the positions of the task, rad. The
/// convex hull of `corners` must contain all x.
///
/// Formula   [T14.29]
/// None      if there is no corner; if the play has no value at a corner; if the pair is internal,
///           double-helical, on crossed axes or not involute; if the flanks have reliefs,
///           topographies or waves; if the lead of a cutter is changed; if flanks can touch near
///           a base circle
/// Laws      (1) no member within the ranges has less play
std::optional<double> least_play_bound(const ContactSetup& setup, const ScatterTask& task,
                                       const std::vector<std::vector<double>>& corners);

}  // namespace gearwright
