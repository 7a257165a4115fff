// The missing inputs of a rating as a list, to which interfaces add missing loads and materials.
#pragma once

#include <vector>

#include "gearwright/base/error.hpp"
#include "gearwright/rating/rating.hpp"

namespace gearwright {

/// The parts of missing_input(). `halves` is 2 for double-helical gears, whose face load factor does
/// not follow from a mounting.
std::vector<Error> missing_inputs(const RatingInput& input, int halves = 1);

}  // namespace gearwright
