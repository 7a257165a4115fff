// The missing inputs of a rating as a list, to which interfaces add missing loads and materials.
#pragma once

#include <vector>

#include "gearwright/base/error.hpp"
#include "gearwright/rating/rating.hpp"

namespace gearwright {

/// The parts of missing_input().
std::vector<Error> missing_inputs(const RatingInput& input);

}  // namespace gearwright
