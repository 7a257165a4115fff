// The missing inputs of a rating, as a list. User interfaces add missing loads and materials to it.
#pragma once

#include <vector>

#include "gearwright/base/error.hpp"
#include "gearwright/rating/rating.hpp"

namespace gearwright {

/// The errors that missing_input() joins into one. `halves` is 2 for double-helical gears, for which a
/// mounting does not give the face load factor.
std::vector<Error> missing_inputs(const RatingInput& input, int halves = 1);

}  // namespace gearwright
