// Tolerances: thickness allowances that are not given as numbers, and the gears at both ends.
// Internal to arrange/.
#pragma once

#include <memory>

#include "gearwright/arrange/arrange.hpp"

namespace gearwright {

/// The input with allowances converted to numbers from DIN 3967, a span, or a dimension over balls.
///
/// Errors    `gearN.tolerance.…`: no such series; a reading that no tooth has; no tool to read it
Result<GivenPair> with_allowances(const GivenPair& given);

/// Gears and pair at both ends; none if there are no tolerances.
///
/// Errors    as arrange() at that end; `pair.backlash` if the tolerance of the centre distance
///           alone exceeds it; `pair.distance_tolerance`
Result<std::shared_ptr<const ArrangedEnds>> arrange_ends(const Arranged& nominal, Scope scope);

}  // namespace gearwright
