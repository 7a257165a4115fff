// The stiffness and root stress of ISO 6336 for the torques of a loaded contact, for comparison.
#pragma once

#include <vector>

#include "gearwright/arrange/loaded_pair.hpp"

namespace gearwright {

/// The values of ISO 6336 at each torque of a result with contact, for solid discs; empty if the
/// standard does not cover the pair.
std::vector<LoadStandard> load_standard(const Arranged& arranged, const LoadAnalysis& answer);

}  // namespace gearwright
