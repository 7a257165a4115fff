// What a rating still wants, one by one, so that a door can add what it wants itself: the load, the
// materials.
#pragma once

#include <vector>

#include "gearwright/base/error.hpp"
#include "gearwright/rating/rating.hpp"

namespace gearwright {

/// The parts of missing_input().
std::vector<Error> missing_inputs(const RatingInput& input);

}  // namespace gearwright
