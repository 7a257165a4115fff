// The keys of [search]: what a design search is asked.
#pragma once

#include "gearwright/catalogue/key.hpp"
#include "gearwright/design/search_problem.hpp"

namespace gearwright {

const KeyTable& search_keys();

}  // namespace gearwright
