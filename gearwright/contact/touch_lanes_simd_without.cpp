// touch_step() without Google Highway, by the scalar code.
#include "gearwright/contact/touch_lanes.hpp"

namespace gearwright::detail {

void touch_step(LaneBlock& block) { touch_step_scalar(block); }

}  // namespace gearwright::detail
