// Makes a change that the verdict tries, in the input, as a user would. Internal to arrange/.
#pragma once

#include "gearwright/arrange/given_pair.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

/// Sets the number. Returns false if the input gives this number in another form, or if the number
/// follows from another gear.
bool make_change(GivenPair& given, const SpecChange& change);

}  // namespace gearwright
