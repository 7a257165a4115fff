// Computes the clearance between tip corners and root fillets. Other checks ensure that the tips
// touch the flanks only at their usable parts and clear the root circles. The only remaining
// interference is then between tip corners and root fillets, mostly at tight centres.
//
//   fillet   the trochoid cut by the tip rounding of the rack; its points have a closed form
//   corner   the corner of the mating tip; its angle at a given radius of the gear follows from a
//            triangle and the gear ratio
//   gap      the minimum over the fillet of (angle of the fillet − angle of the corner)·radius
//                                              theory: docs/theory/09-design-search.md, 9.3
//
// The gap is measured along a circle. It has the same sign as the distance between corner and
// fillet, and at least the same magnitude. Near the start of the flank, the gap is small, because
// the corner has just left the flank. Only the sign of the gap is therefore checked, and the form
// clearance serves as the margin.
#pragma once

#include <optional>

#include "gearwright/base/vector.hpp"
#include "gearwright/design/shift_graph.hpp"

namespace gearwright {

/// Returns the smaller of the gaps of both gears for given shifts, modules. The gap is negative if
/// a corner cuts into a fillet. The result is absent for internal and crossed pairs, and if no
/// corner reaches a fillet.
///
/// Domain    a working pressure angle exists, and no gear is undercut
std::optional<double> fillet_gap(const ShiftGraph& graph, const Vec2& shifts);

/// True if a corner cuts into a fillet for these shifts. The result is false if SearchLimits does
/// not enable this check (clear_fillets).
bool fillet_is_cut(const ShiftGraph& graph, const Vec2& shifts);

}  // namespace gearwright
