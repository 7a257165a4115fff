// The keys of [search]: the inputs of a design search.
#pragma once

#include "gearwright/catalogue/key.hpp"
#include "gearwright/design/search_problem.hpp"

namespace gearwright {

const KeyTable& search_keys();

}  // namespace gearwright
