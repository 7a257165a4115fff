// The keys of [load] and [[load.probe]], which are the torque and the resolution of the
// computation.
#pragma once

#include "gearwright/arrange/load_input.hpp"
#include "gearwright/catalogue/key.hpp"

namespace gearwright {

const KeyTable& load_keys();
const KeyTable& load_probe_keys();

}  // namespace gearwright
