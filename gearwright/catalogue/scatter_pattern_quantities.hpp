// The quantities of the density of contact patterns: `scatter.pattern` of a result.
#pragma once

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/scatter/pattern_density.hpp"

namespace gearwright {

const Quantities<PatternDensity>& density_quantities();

}  // namespace gearwright
