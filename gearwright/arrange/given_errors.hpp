// Attributes errors of a gear or a pair to the given number from which the faulty number follows.
// Internal to arrange/.
#pragma once

#include "gearwright/arrange/given_pair.hpp"

namespace gearwright {

/// The error of a gear as an error of gear 1 or 2. If the gear is given by its base cylinder, the user
/// has not given the numbers of a rack, so the message names the rack that describes the gear.
Error of_given_gear(Error error, const GivenPair& given, int which);

/// If a gear is given by its base cylinder, replaces the numbers of its rack in the error of a pair by
/// the numbers of the base cylinder.
Error of_basic(const Error& error, const GivenPair& given);

/// Attributes an error in the end radius of a tooth to the given tip clearance that determines it.
Error of_clearance(const Error& error, const GivenPair& given, int which);

/// Attributes the error of a computed profile shift to the centre distance from which it follows.
Error of_distance(const Error& error, const GivenPair& given);

/// The error with the kind `placement` instead of `value`; any other kind is kept.
Error not_placed(Error error);

}  // namespace gearwright
