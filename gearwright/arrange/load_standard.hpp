// Mesh stiffness and root stress by ISO 6336, for comparison with the results of loaded contact.
#pragma once

#include <vector>

#include "gearwright/arrange/loaded_pair.hpp"

namespace gearwright {

/// The values of ISO 6336 for solid discs, at each torque for which `answer` has contact. Empty if
/// the standard does not cover the pair.
std::vector<LoadStandard> load_standard(const Arranged& arranged, const LoadAnalysis& answer);

}  // namespace gearwright
