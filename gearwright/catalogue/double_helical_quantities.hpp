// Additional quantities of a gear of two halves.
#pragma once

#include "gearwright/arrange/two_halves.hpp"
#include "gearwright/catalogue/quantity.hpp"

namespace gearwright {

const Quantities<Halves>& double_helical_quantities();

}  // namespace gearwright
