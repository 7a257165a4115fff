// The keys of [search] for a search for pairs.
#pragma once

#include "gearwright/catalogue/key.hpp"
#include "gearwright/design/search_problem.hpp"

namespace gearwright {

const KeyTable& search_keys();

}  // namespace gearwright
