// The gears and the pair at the mean of their tolerances, which need not be known.
// Internal to arrange/.
#pragma once

#include "gearwright/arrange/arrange.hpp"

namespace gearwright {

/// As arrange(), without `ends` and `given`; allowances that follow from a series or a reading count
/// only once they are numbers (with_allowances).
Result<Arranged> arrange_nominal(const GivenPair& given, Scope scope);

}  // namespace gearwright
