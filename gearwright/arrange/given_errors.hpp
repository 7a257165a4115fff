// Errors of a gear or a pair, attributed to the given number instead of a number that follows from
// it. Internal to arrange/.
#pragma once

#include "gearwright/arrange/given_pair.hpp"

namespace gearwright {

/// The error of a gear as an error of gear 1 or 2. If a gear is given by its base cylinder, the
/// numbers of a rack are not its own, so the error names the rack that describes the gear.
Error of_given_gear(Error error, const GivenPair& given, int which);

/// Replaces the numbers of racks in the error of a pair by the own numbers of a gear that is given
/// by its base cylinder.
Error of_basic(const Error& error, const GivenPair& given);

/// Attributes an error of the end of a tooth to the given tip clearance that determines it.
Error of_clearance(const Error& error, const GivenPair& given, int which);

/// Attributes an error of an absent shift to the centre distance from which the shift follows.
Error of_distance(const Error& error, const GivenPair& given);

/// An error of placing the gears, with that kind if it has no other.
Error not_placed(Error error);

}  // namespace gearwright
