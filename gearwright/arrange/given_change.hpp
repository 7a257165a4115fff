// A change that the verdict tries, made in the input as a user would make it. Internal to arrange/.
#pragma once

#include "gearwright/arrange/given_pair.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

/// Sets the number. Returns false if the input gives it in another form, or leaves it to another
/// gear.
bool make_change(GivenPair& given, const SpecChange& change);

}  // namespace gearwright
