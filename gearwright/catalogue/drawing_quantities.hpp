// The title block as a result: `drawing`, the words of the spec's table of that name.
#pragma once

#include "gearwright/catalogue/drawing_keys.hpp"
#include "gearwright/catalogue/quantity.hpp"

namespace gearwright {

const Quantities<DrawingInput>& drawing_quantities();

}  // namespace gearwright
