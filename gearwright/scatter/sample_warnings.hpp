// Warns if some samples of a family do not run well.
#pragma once

#include <vector>

#include "gearwright/gear/warning.hpp"
#include "gearwright/scatter/scatter.hpp"

namespace gearwright {

/// Warns if samples jam, lose contact, or often have edge contact.
std::vector<Warning> sample_warnings(const Scatter& scatter);

}  // namespace gearwright
