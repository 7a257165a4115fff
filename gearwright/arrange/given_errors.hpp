// Rewrites an error about a computed number so that it names the given number from which the
// computed one follows. Internal to arrange/.
#pragma once

#include "gearwright/arrange/given_pair.hpp"

namespace gearwright {

/// Converts the error of a gear to an error of gear 1 or 2. If the gear is given by its base
/// cylinder, the input contains no rack data, so the message names the rack that describes the
/// gear.
Error of_given_gear(Error error, const GivenPair& given, int which);

/// Replaces rack data in the error of a pair by the data of the base cylinder, if the named gear is
/// given by its base cylinder.
Error of_basic(const Error& error, const GivenPair& given);

/// Attributes an error in the radius at which the tooth ends to the given tip clearance.
Error of_clearance(const Error& error, const GivenPair& given, int which);

/// Attributes the error of a computed profile shift to the given centre distance.
Error of_distance(const Error& error, const GivenPair& given);

/// Changes the kind of the error from `value` to `placement`. Any other kind is unchanged.
Error not_placed(Error error);

}  // namespace gearwright
