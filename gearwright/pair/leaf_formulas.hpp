// Formulas of two gears in mesh for any scalar type. The formulas are in pair/leaf_formulas.inc.
#pragma once

#include <cmath>

#include "gearwright/gear/leaf_formulas.hpp"

namespace gearwright::leaf {

#define GW_LEAF_INLINE inline
#include "gearwright/pair/leaf_formulas.inc"
#undef GW_LEAF_INLINE

}  // namespace gearwright::leaf
