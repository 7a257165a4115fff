// The keys of [load] and [[load.probe]]: torque, and how finely teeth under it are looked at.
#pragma once

#include "gearwright/arrange/load_input.hpp"
#include "gearwright/catalogue/key.hpp"

namespace gearwright {

const KeyTable& load_keys();
const KeyTable& load_probe_keys();

}  // namespace gearwright
