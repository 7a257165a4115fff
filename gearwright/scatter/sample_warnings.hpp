// Warns about samples of a family of pairs that do not run well.
#pragma once

#include <vector>

#include "gearwright/gear/warning.hpp"
#include "gearwright/scatter/scatter.hpp"

namespace gearwright {

/// Warnings about samples that jam, lose contact or often touch with an edge.
std::vector<Warning> sample_warnings(const Scatter& scatter);

}  // namespace gearwright
