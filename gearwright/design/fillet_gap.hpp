// Clearance of the tip corners to the root fillets. It is the only remaining interference of a pair
// whose tips stay on the flanks and clear of the root circles, mostly at tight centre distances.
//
//   fillet   the trochoid that the tip rounding of the rack cuts, point by point in closed form
//   corner   of the mating tip, on its circle about the other axis; where it passes a radius, its
//            angle in the gear follows from a triangle and the ratio of the teeth
//   gap      the least of (angle of the fillet − angle of the corner)·radius over the fillet:
//            measured along the circle, so it has the sign of the distance and is no less than it.
//            Near the start of the flank it is small, because the corner has just left the flank
//            there. Only its sign is checked, and the form clearance is the margin.
//                                              theory: docs/theory/09-design-search.md, 9.3
#pragma once

#include <optional>

#include "gearwright/base/vector.hpp"
#include "gearwright/design/shift_graph.hpp"

namespace gearwright {

/// The lesser gap of both gears at a point, modules; negative if a corner cuts into a fillet. None
/// for internal and crossed pairs, and for corners that do not reach the fillet.
///
/// Domain    a working angle exists, no gear is undercut
std::optional<double> fillet_gap(const ShiftGraph& graph, const Vec2& shifts);

/// True if this check is enabled (SearchLimits::clear_fillets) and a corner cuts into a fillet at
/// this point.
bool fillet_is_cut(const ShiftGraph& graph, const Vec2& shifts);

}  // namespace gearwright
