// What is possible with racks of circular arcs, and what is not.
#pragma once

#include <optional>
#include <string>

#include "gearwright/arrange/given_pair.hpp"

namespace gearwright {

/// A gear, or a cutter of one, has a rack of arcs.
bool has_arcs(const GivenPair& given);

/// What has no meaning for circular-arc teeth: a gear cut by one of them, tips shortened by profile
/// shifts, crossed axes.
std::optional<Error> check_arcs(const GivenPair& given);

/// Refuses racks of arcs for a verb that knows involute gears only.
std::optional<Error> refuse_arcs(const GivenPair& given, const std::string& verb);

}  // namespace gearwright
