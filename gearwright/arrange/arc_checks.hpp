// What is possible with racks of circular arcs, and what is not.
#pragma once

#include <optional>

#include "gearwright/arrange/given_pair.hpp"

namespace gearwright {

/// The gear's rack, or that of its cutter, consists of arcs.
bool has_arcs(const GearInput& gear);

/// One of the gears has arcs.
bool has_arcs(const GivenPair& given);

/// What has no meaning for circular-arc teeth: a gear cut by one of them, tips shortened by profile
/// shifts, crossed axes.
std::optional<Error> check_arcs(const GivenPair& given);

}  // namespace gearwright
