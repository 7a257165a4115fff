// The keys of [pair]: how the two gears are mounted.
#pragma once

#include "gearwright/arrange/given_pair.hpp"
#include "gearwright/catalogue/key.hpp"

namespace gearwright {

const KeyTable& pair_keys();

}  // namespace gearwright
