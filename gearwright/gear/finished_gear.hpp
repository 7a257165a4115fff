// Computes the data of a gear that do not depend on the kind of cutter. Data in closed form are
// computed before the tooth is cut, and tip, root and warnings afterwards. Internal to gear/.
#pragma once

#include <optional>
#include <string>

#include "gearwright/gear/gear.hpp"

namespace gearwright::detail {

/// Returns the gear without its tooth, with reference geometry, diameters from the rack, lead and
/// pointed diameter.
Gear described(const CylindricalSpec& spec);

/// Sets root and tip of the tooth as cut, and adds the warnings.
void finish(Gear& gear);

void warn(Gear& gear, WarningCode code, std::string message);

// A gear with circular-arc (Wildhaber-Novikov) teeth of any kind, cut by a rack of arcs.

/// Returns the normal angle τ at which the envelope of the circle has a cusp. Cusps beyond the end
/// of the arc at the tip of the tooth are ignored. If several cusps remain, the function returns
/// the one nearest to this end. The cutter undercuts a convex tooth below this angle, and a concave
/// tooth above it. Returns none if no cusp remains.
///
/// Formula   F(sin τ) = 0, [T3.9]; [T7.12]
std::optional<Angle> undercut_limit(const RackMotion& motion, const EdgeCircle& circle);

/// Makes the gear from the arcs of its rack. make_gear() calls this function.
///
/// Domain    check_limits() returns no error
/// Errors    the error of `rack`; `teeth` for an internal gear; `profile_shift`, `root_fillet` or
///           `tip_fillet` if it is given, because teeth of arcs have none; `tip_diameter`
Result<Gear> make_arc_gear(const CylindricalSpec& spec, const Result<RackOfArcs>& rack);

}  // namespace gearwright::detail
