// The keys of [pair], which describe the mounting of the two gears.
#pragma once

#include "gearwright/arrange/given_pair.hpp"
#include "gearwright/catalogue/key.hpp"

namespace gearwright {

const KeyTable& pair_keys();

/// The keys of [gear2] if gear 2 is a rack.
const KeyTable& rack_bar_keys();

}  // namespace gearwright
