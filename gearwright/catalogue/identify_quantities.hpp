// The quantities of `identify`: the gears that readings of an unknown one allow.
#pragma once

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/inspection/identify.hpp"

namespace gearwright {

const Quantities<Identification>& identify_quantities();

/// One of its candidates.
const Quantities<IdentifiedGear>& identified_gear_quantities();

}  // namespace gearwright
