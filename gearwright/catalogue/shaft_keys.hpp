// The keys of [gear1.shaft] and [gear2.shaft]: the bearings, the diameters and the side of the
// torque.
#pragma once

#include <cstddef>

#include "gearwright/catalogue/key.hpp"
#include "gearwright/compliance/shaft.hpp"

namespace gearwright {

const KeyTable& shaft_keys();

constexpr std::size_t kMostShaftDiameters = 50;

}  // namespace gearwright
