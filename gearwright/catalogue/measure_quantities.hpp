// The quantities that a workshop measures, and the description of a gear by another rack. They are
// `measure` and `as_rack` in a result.
#pragma once

#include "gearwright/arrange/measured_gear.hpp"
#include "gearwright/catalogue/quantity.hpp"

namespace gearwright {

/// The measurements of one gear.
const Quantities<GearMeasures>& measure_quantities();

/// Data of a rack that would cut the same teeth.
const Quantities<ReferenceInput<double>>& as_rack_quantities();

}  // namespace gearwright
