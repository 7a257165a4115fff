// The tip diameter at which contact stays on the mating gear's usable flank.
#pragma once

#include <optional>

#include "gearwright/pair/involute_pair.hpp"

namespace gearwright {

/// The greatest tip diameter (internal gear: the least) of gear `tip` (1 or 2). With this diameter,
/// contact ends on the mating gear at a radius `margin` mm above the start of its usable flank. If
/// this start is not known, the mating gear's base circle is used. None if the tip need not be
/// turned down, or if the mating gear is an internal gear without a known start of its flank.
std::optional<double> tip_that_clears(const InvolutePair& pair, int tip, double margin = 0.0);

}  // namespace gearwright
