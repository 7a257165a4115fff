// Checks whether the input is possible for gears with circular-arc teeth.
#pragma once

#include <optional>

#include "gearwright/arrange/given_pair.hpp"

namespace gearwright {

/// True if the gear has circular-arc teeth: its own rack, or the rack of its cutter, consists of
/// arcs.
bool has_arcs(const GearInput& gear);

/// True if at least one gear of the pair has circular-arc teeth.
bool has_arcs(const GivenPair& given);

/// Rejects inputs that have no meaning for circular-arc teeth: a pinion cutter with such teeth, tip
/// shortening that follows from profile shifts, and crossed axes.
std::optional<Error> check_arcs(const GivenPair& given);

}  // namespace gearwright
