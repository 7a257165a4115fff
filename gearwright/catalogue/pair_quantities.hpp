// The quantities of a mounted pair: `pair` in a result, and the table of pair data.
#pragma once

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

const Quantities<Pair>& pair_quantities();

}  // namespace gearwright
