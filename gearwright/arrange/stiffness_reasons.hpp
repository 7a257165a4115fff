// Why teeth under load are softer or stiffer than the standard has them: the same pair once more
// without its errors, without its modifications, with a wider face, with solid bodies.
#pragma once

#include "gearwright/arrange/loaded_pair.hpp"

namespace gearwright {

/// Where the mean stiffness is more than a quarter off c_γα: a note, with the
/// factor that each of these makes and what is left.
///
/// Domain    an answer of this task with contact (contract)
void explain_stiffness(const Arranged& arranged, const LoadTask& task, const LoadAnalysis& answer,
                       std::vector<Warning>& warnings);

}  // namespace gearwright
