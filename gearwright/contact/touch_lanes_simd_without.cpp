// Without Google Highway, a step uses the scalar code, with which tests compare the vector code.
#include "gearwright/contact/touch_lanes.hpp"

namespace gearwright::detail {

void touch_step(LaneBlock& block) { touch_step_scalar(block); }

}  // namespace gearwright::detail
