// Narrows the bounds of corrections to values that the teeth can have. Internal to contact/.
#pragma once

#include "gearwright/contact/compensation.hpp"

namespace gearwright::detail {

/// If no teeth exist with one correction at its bound and all others at 0, the function moves this
/// bound towards 0. A bound that would become 0 stays unchanged. Without this function, most trials
/// of a search would have no teeth.
CompensationTask within_teeth(CompensationTask task);

}  // namespace gearwright::detail
