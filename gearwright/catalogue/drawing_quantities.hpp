// The title block as a result: `drawing` contains the texts of the table [drawing] of the spec.
#pragma once

#include "gearwright/catalogue/drawing_keys.hpp"
#include "gearwright/catalogue/quantity.hpp"

namespace gearwright {

const Quantities<DrawingInput>& drawing_quantities();

}  // namespace gearwright
