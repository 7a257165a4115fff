// Computes mean, standard deviation, percentiles and probabilities of one quantity over the samples
// of a family, with their intervals.
//
// Internal to scatter/.                theory: docs/theory/14-scatter.md, [T14.6] to [T14.9]
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "gearwright/scatter/scatter.hpp"

namespace gearwright {

/// The possible values of a quantity, to which the intervals of its percentiles are limited.
struct PossibleValues {
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();
};
constexpr PossibleValues kNotNegative{.least = 0.0};

/// Returns the spread of `values`. The values are stored replicate by replicate, with
/// `per_replicate` values in each. Percentile::sample is an index of `values`. Returns none if no
/// sample has a value.
std::optional<Spread> spread_of(const ScatterTask& task, const SampleValues& values,
                                int per_replicate, const PossibleValues& possible = {});

Probability probability_of(std::int64_t count, std::int64_t of, double confidence);

/// Returns the probability that `is` is true, from the fraction of the samples for which it is.
template <class Samples, class F>
Probability share_of(const Samples& samples, double confidence, const F& is) {
  return probability_of(std::count_if(samples.begin(), samples.end(), is),
                        static_cast<std::int64_t>(samples.size()), confidence);
}

}  // namespace gearwright
