// The keys of [gear2] if gear 2 is a rack.
#pragma once

#include "gearwright/catalogue/key.hpp"

namespace gearwright {

const KeyTable& rack_bar_keys();

}  // namespace gearwright
