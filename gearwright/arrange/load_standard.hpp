// Mesh stiffness and root stress by ISO 6336, for comparison with the results of loaded contact.
#pragma once

#include <vector>

#include "gearwright/arrange/loaded_pair.hpp"

namespace gearwright {

/// The values of ISO 6336 for solid discs, at each torque for which `answer` contains contact.
/// Empty if the standard does not cover the pair.
std::vector<LoadStandard> load_standard(const Arranged& arranged, const LoadAnalysis& answer);

// Finds the reasons why teeth under load are softer or stiffer than ISO 6336 predicts. For this
// purpose, the pair is computed again: without errors, then also without modifications, and then
// with a wider face and with solid bodies.

/// Adds a note if the mean stiffness differs from c_γα by more than a quarter. The note gives the
/// factor of each cause and the remaining factor.
///
/// Domain    a result of this task with contact (contract)
void explain_stiffness(const Arranged& arranged, const LoadTask& task, const LoadAnalysis& answer,
                       std::vector<Warning>& warnings);

}  // namespace gearwright
