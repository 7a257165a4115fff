// The family under torque: transmission error, pressure and distribution of the load of its first
// samples.
//
// The tables of the teeth do not depend on errors and modifications, so all members share them. The
// teeth of a gear are alike here: pitch deviations have no effect, and a thickness only turns gear 2.
//
// Internal to scatter/.                theory: docs/theory/14-scatter.md, [T14.24]
#pragma once

#include <vector>

#include "gearwright/load/loaded_score.hpp"
#include "gearwright/scatter/scatter.hpp"

namespace gearwright {

/// The scores by torque of the members at these x; empty if the forces have no solution at some
/// position.
///
/// Accuracy  of a member as loaded_contact()
std::vector<std::vector<LoadedScore>> scores_under_load(const ContactSetup& setup,
                                                        const ScatterTask& task,
                                                        const LoadedFamily& load,
                                                        const std::vector<std::vector<double>>& x);

/// The peak to peak of each member under the worst of the torques, rad; `none` without scores.
std::vector<double> loaded_peaks(const std::vector<std::vector<LoadedScore>>& scores, double none);

/// Statistics of scores, replicate by replicate; Percentile::sample is an index of `scores`.
std::vector<LoadedSpread> spreads_under_load(const ScatterTask& task, const LoadedFamily& load,
                                             const std::vector<std::vector<LoadedScore>>& scores);

/// One for each torque of task.load, from the first task.load->samples samples of each replicate.
///
/// Domain    task.load is given; `samples` are those of scatter_of() (contract)
/// Accuracy  of a member as loaded_contact()
/// Laws      (1) without deviations the numbers are those of loaded_contact()
///           (2) the same bytes on any number of threads
std::vector<LoadedSpread> loaded_spreads(const ContactSetup& setup, const ScatterTask& task,
                                         const std::vector<ScatterSample>& samples);

}  // namespace gearwright
