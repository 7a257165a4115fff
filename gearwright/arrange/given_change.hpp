// Makes a change that a verdict proposes, in the input, as a user would. Internal to arrange/.
#pragma once

#include "gearwright/arrange/given_pair.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

/// Sets the number. Returns false if the input gives this number in another form, or if another
/// gear determines it.
bool make_change(GivenPair& given, const SpecChange& change);

}  // namespace gearwright
