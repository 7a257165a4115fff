// Statistics of one quantity over the samples of a family: mean, standard deviation, percentiles
// and probabilities with their intervals.
//
// Internal to scatter/.                theory: docs/theory/14-scatter.md, [T14.6] to [T14.9]
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "gearwright/scatter/scatter.hpp"

namespace gearwright {

/// The spread of `values`. The values are stored replicate by replicate, with `per_replicate`
/// values in each, and NaN for a sample without a value. Percentile::sample is an index of
/// `values`. None if no sample has a value.
std::optional<Spread> spread_of(const ScatterTask& task, const std::vector<double>& values,
                                int per_replicate);

Probability probability_of(std::int64_t count, std::int64_t of, double confidence);

}  // namespace gearwright
