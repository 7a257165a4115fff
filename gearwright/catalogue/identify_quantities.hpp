// The quantities of `identify`: the gears that agree with the readings of an unknown gear.
#pragma once

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/inspection/identify.hpp"

namespace gearwright {

const Quantities<Identification>& identify_quantities();

/// The quantities of one candidate.
const Quantities<IdentifiedGear>& identified_gear_quantities();

}  // namespace gearwright
