// A gear cut by a rack of arcs: circular-arc (Wildhaber-Novikov) teeth of every kind.
//
// Internal to gear/: make_gear calls this if the spec has such a rack.
#pragma once

#include "gearwright/gear/gear.hpp"

namespace gearwright::detail {

/// The normal angle τ at which the circle's envelope has the cusp that limits it on the side of the
/// root: below (a convex tooth) or beyond it (a concave one) the cutter undercuts. None if there is
/// no cusp on the quarter circle.
///
/// Formula   F(sin τ) = 0, [T3.9]; [T7.12]
std::optional<Angle> undercut_limit(const RackMotion& motion, const EdgeCircle& circle);

/// Makes the gear from the arcs of the spec, if its rack is one of arcs.   Domain  check_limits
/// found nothing
///
/// Errors    as the rack's own; `teeth` for an internal gear; `profile_shift`, `root_fillet`,
///           `tip_fillet`, which these teeth do not have; `tip_diameter`
Result<Gear> make_arc_gear(const CylindricalSpec& spec, const Result<RackOfArcs>& rack);

}  // namespace gearwright::detail
