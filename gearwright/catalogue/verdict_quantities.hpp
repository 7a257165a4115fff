// The quantities of a verdict, which are `verdict` in a result.
#pragma once

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

const Quantities<Verdict>& verdict_quantities();

}  // namespace gearwright
