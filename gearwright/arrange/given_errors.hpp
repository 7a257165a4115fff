// Errors of a gear or a pair, put to the number that was given and not to one that follows from it.
// Internal to arrange/.
#pragma once

#include "gearwright/arrange/given_pair.hpp"

namespace gearwright {

/// The error of a gear as one of gear 1 or 2. The numbers of a rack are not those of a gear that is
/// given by its base cylinder: the error names the rack that describes this gear.
Error of_given_gear(Error error, const GivenPair& given, int which);

/// A pair names its gears' racks; the numbers of a gear given by its base cylinder are its own.
Error of_basic(const Error& error, const GivenPair& given);

/// A tip with a clearance: the radius at which it ends was not given.
Error of_clearance(const Error& error, const GivenPair& given, int which);

/// An absent shift cannot be wrong: it followed from the centre distance.
Error of_distance(const Error& error, const GivenPair& given);

/// An error of placing the gears, with that kind if it has no other.
Error not_placed(Error error);

}  // namespace gearwright
