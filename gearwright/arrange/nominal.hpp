// Computes the gears and the pair at the mean of their tolerances, if they have any.
// Internal to arrange/.
#pragma once

#include "gearwright/arrange/arrange.hpp"

namespace gearwright {

/// Computes the result of arrange() without `ends` and `given`. The caller must have converted
/// allowances that follow from a series or a measurement to numbers (with_allowances).
Result<Arranged> arrange_nominal(const GivenPair& given, Scope scope);

}  // namespace gearwright
