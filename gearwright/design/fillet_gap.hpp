// Clearance between the tip corners and the root fillets. If the tips of a pair stay on the flanks and
// clear of the root circles, this is the only interference that is still possible. It occurs mostly at
// tight centre distances.
//
//   fillet   the trochoid that the tip rounding of the rack cuts; its points have a closed form
//   corner   the corner of the mating tip; where it passes a radius of the gear, its angle in the gear
//            follows from a triangle and the gear ratio
//   gap      the least of (angle of the fillet − angle of the corner)·radius over the fillet
//                                              theory: docs/theory/09-design-search.md, 9.3
//
// The gap is measured along a circle, so it has the sign of the distance and is not smaller. Near the
// start of the flank it is small, because the corner has just left the flank there. Therefore only its
// sign is checked, and the form clearance serves as margin.
#pragma once

#include <optional>

#include "gearwright/base/vector.hpp"
#include "gearwright/design/shift_graph.hpp"

namespace gearwright {

/// The lesser gap of both gears at a point, modules; negative if a corner cuts into a fillet. None for
/// internal and crossed pairs, and if no corner reaches a fillet.
///
/// Domain    a working pressure angle exists, and no gear is undercut
std::optional<double> fillet_gap(const ShiftGraph& graph, const Vec2& shifts);

/// True if this check is enabled (SearchLimits::clear_fillets) and a corner cuts into a fillet at
/// this point.
bool fillet_is_cut(const ShiftGraph& graph, const Vec2& shifts);

}  // namespace gearwright
