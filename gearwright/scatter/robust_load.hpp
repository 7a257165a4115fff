// Finds the corrections that minimise a percentile of the loaded peak-to-peak TE, and evaluates a
// family with given corrections.
//                                    theory: docs/theory/14-scatter.md, [T14.25]
// Internal to scatter/.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/scatter/robust.hpp"

namespace gearwright {

/// Returns the best corrections for the first samples of the family. They are not rounded.
///
/// Domain    as robust_corrections(), with a load and with the fields that the corrections need
///           (contract)
std::vector<double> corrections_under_load(const ContactSetup& setup, const ScatterTask& task,
                                           const RobustTask& robust);

/// Computes the family of the task `judged`. f of a sample is the loaded peak to peak under the
/// worst of the torques. The result is none if no sample has a solution.
std::optional<JudgedFamily> judged_under_load(const ContactSetup& setup, const ScatterTask& judged,
                                              const LoadedFamily& load);

}  // namespace gearwright
