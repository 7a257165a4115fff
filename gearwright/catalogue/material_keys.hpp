// The keys of [gearN.material]: the material of the teeth, for loads and ratings.
#pragma once

#include "gearwright/arrange/given_material.hpp"
#include "gearwright/catalogue/key.hpp"

namespace gearwright {

const KeyTable& material_keys();

}  // namespace gearwright
