// The quantities of a mounted pair, for the table of pair data. A result contains them under
// `pair`.
#pragma once

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/pair/pair.hpp"
#include "gearwright/pair/rack_pair.hpp"

namespace gearwright {

const Quantities<Pair>& pair_quantities();

// The quantities of a rack and of its pair with a pinion. A result for a rack and its pinion
// contains them under `gears` and `pair`.

const Quantities<RackGeometry>& rack_quantities();
const Quantities<RackPair>& rack_pair_quantities();

}  // namespace gearwright
