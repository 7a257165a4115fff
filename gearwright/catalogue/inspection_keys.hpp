// What a spec says of measuring a gear: [gearN.measure], the tools, and [gearN.tolerance], what the
// readings may be.
#pragma once

#include "gearwright/arrange/given_gear.hpp"
#include "gearwright/catalogue/key.hpp"

namespace gearwright {

const KeyTable& measure_keys();
const KeyTable& tolerance_keys();

}  // namespace gearwright
