// Checks which inputs are possible with racks of circular arcs.
#pragma once

#include <optional>

#include "gearwright/arrange/given_pair.hpp"

namespace gearwright {

/// True if the gear's rack, or that of its cutter, consists of arcs.
bool has_arcs(const GearInput& gear);

/// True if one of the gears has arcs.
bool has_arcs(const GivenPair& given);

/// Rejects inputs that have no meaning for circular-arc teeth: a cutter with such teeth, tips shortened
/// because of profile shifts, crossed axes.
std::optional<Error> check_arcs(const GivenPair& given);

}  // namespace gearwright
