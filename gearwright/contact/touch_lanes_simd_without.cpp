// Without Google Highway a step uses plain doubles, which are the reference for tests of the vector
// code.
#include "gearwright/contact/touch_lanes.hpp"

namespace gearwright::detail {

void touch_step(LaneBlock& block) { touch_step_scalar(block); }

}  // namespace gearwright::detail
