// Computes the transmission error, the pressure and the load distribution under torque for the
// first samples of a family.
//
// The tables of the teeth do not depend on errors and modifications, so all members share them.
// All teeth of a gear are treated as identical. Pitch deviations therefore have no effect, and a
// change of thickness only turns gear 2.
//
// Internal to scatter/.                theory: docs/theory/14-scatter.md, [T14.24]
#pragma once

#include <memory>
#include <vector>

#include "gearwright/load/load_summary.hpp"
#include "gearwright/scatter/scatter.hpp"

namespace gearwright {

struct LoadedSide {
  std::shared_ptr<const ContactPair> pair;
  LoadRequest request;
};
/// Returns the pair of a member with these errors. For a double-helical pair, the half at z > 0 and
/// the mirror image of the other half are returned. If both are equal, the mirror image is omitted.
std::vector<LoadedSide> loaded_sides(const ContactSetup& setup, const ContactErrors& errors,
                                     const MemberRequest& member, const LoadedFamily& load);

/// Returns the scores of the members at the points `x`. Each member has a list with one score for
/// each torque. The list is empty if the forces on this member have no solution at some position.
///
/// Accuracy  as loaded_contact() for each member
std::vector<std::vector<LoadedScore>> scores_under_load(const ContactSetup& setup,
                                                        const ScatterTask& task,
                                                        const LoadedFamily& load,
                                                        const std::vector<std::vector<double>>& x);

/// Returns the peak-to-peak TE of each member under the worst torque, rad, or none without scores.
SampleValues loaded_peaks(const std::vector<std::vector<LoadedScore>>& scores);

/// Returns statistics of `scores`, which are stored replicate by replicate. Percentile::sample is
/// an index of `scores`.
std::vector<LoadedSpread> spreads_under_load(const ScatterTask& task, const LoadedFamily& load,
                                             const std::vector<std::vector<LoadedScore>>& scores);

/// Returns the spreads for each torque of task.load, from the first task.load->samples samples of
/// each replicate.
///
/// Domain    task.load is given; `samples` come from scatter_of() (contract)
/// Accuracy  as loaded_contact() for each member
/// Laws      (1) without deviations, the numbers are those of loaded_contact()
///           (2) the result is the same, byte for byte, for any number of threads
std::vector<LoadedSpread> loaded_spreads(const ContactSetup& setup, const ScatterTask& task,
                                         const std::vector<ScatterSample>& samples);

}  // namespace gearwright
