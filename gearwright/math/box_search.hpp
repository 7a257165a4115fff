// DIRECT-L: searches a whole box by dividing it into thirds. Internal to math/.
#pragma once

#include <vector>

#include "gearwright/math/trials.hpp"

namespace gearwright::detail {

/// The best point of the box.
std::vector<double> search_box(const MinimiserTask& task, Trials& trials);

}  // namespace gearwright::detail
