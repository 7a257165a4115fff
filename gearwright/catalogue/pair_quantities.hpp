// The quantities of a mounted pair, for the table of pair data. A result contains them under
// `pair`.
#pragma once

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

const Quantities<Pair>& pair_quantities();

}  // namespace gearwright
