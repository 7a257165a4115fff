// Implements touch_step() without Google Highway. A step uses the scalar code, which is also
// the reference for the tests of the vector code.
#include "gearwright/contact/touch_lanes.hpp"

namespace gearwright::detail {

void touch_step(LaneBlock& block) { touch_step_scalar(block); }

}  // namespace gearwright::detail
