// The tip diameter at which contact stays on the mating gear's usable flank.
#pragma once

#include <optional>

#include "gearwright/pair/involute_pair.hpp"

namespace gearwright {

/// The tip diameter of gear `tip` (1 or 2) at which its contact ends where the mating gear's usable
/// flank begins (on its base circle where no flank is known), `margin` mm of radius further out; none
/// if the tip need not be turned down or the mating flank has no such end. It is the greatest
/// possible diameter; for an internal gear the least.
std::optional<double> tip_that_clears(const InvolutePair& pair, int tip, double margin = 0.0);

}  // namespace gearwright
