// Errors of a gear or a pair, attributed to the given number instead of a number that follows from
// it. Internal to arrange/.
#pragma once

#include "gearwright/arrange/given_pair.hpp"

namespace gearwright {

/// The error of a gear as an error of gear 1 or 2. If a gear is given by its base cylinder, the
/// numbers of a rack are not its own, so the error names the rack that describes the gear.
Error of_given_gear(Error error, const GivenPair& given, int which);

/// An error of a pair names the racks of its gears. A gear given by its base cylinder has its own
/// numbers instead.
Error of_basic(const Error& error, const GivenPair& given);

/// For a tip with a clearance, the radius of the end was not given.
Error of_clearance(const Error& error, const GivenPair& given, int which);

/// An absent shift cannot be wrong, because it follows from the centre distance.
Error of_distance(const Error& error, const GivenPair& given);

/// An error of placing the gears, with that kind if it has no other.
Error not_placed(Error error);

}  // namespace gearwright
