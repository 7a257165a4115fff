// The quantities of a verdict. A result contains them under `verdict`.
#pragma once

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

const Quantities<Verdict>& verdict_quantities();

}  // namespace gearwright
