// Changes the input as a verdict proposes. Internal to arrange/.
#pragma once

#include "gearwright/arrange/given_pair.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

/// Sets the changed number in the input. Returns false if the input gives this number in another
/// form, or if another gear determines it.
bool make_change(GivenPair& given, const SpecChange& change);

}  // namespace gearwright
