#include "gearwright/scatter/spread.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "gearwright/base/numbers.hpp"

namespace gearwright {

namespace {

// Returns a statistic Y of all samples, with its standard error according to [T14.9]. Y has less
// bias than the values Y_r of the replicates, which have fewer samples.
Estimate pooled(double of_all, std::span<const double> of_replicates) {
  const auto r = static_cast<double>(of_replicates.size());
  if (r < 2.0) return {of_all, std::nullopt};
  double squares = 0.0;
  for (const double y : of_replicates) squares += (y - of_all) * (y - of_all);
  return {of_all, std::sqrt(squares / (r * (r - 1.0)))};
}

Percentile percentile_of(const ScatterTask& task, double percent, const SampleValues& values,
                         const std::vector<double>& sorted,
                         const std::vector<std::vector<double>>& sorted_replicates,
                         const PossibleValues& possible) {
  const double p = percent / 100.0;
  std::vector<double> each;
  for (const auto& r : sorted_replicates) each.push_back(quantile(r, p));
  Percentile found{percent, pooled(quantile(sorted, p), each), {}, {}, 0};
  if (task.sampling == Sampling::sobol && found.estimate.standard_error) {
    const ConfidenceInterval i = interval(found.estimate, each.size(), task.confidence);
    found.lower = std::max(i.lower, possible.least);
    found.upper = std::min(i.upper, possible.greatest);
  } else {
    const auto ranks = quantile_ranks(static_cast<std::int64_t>(sorted.size()), p, task.confidence);
    const auto at = [&](std::int64_t rank) { return sorted[static_cast<std::size_t>(rank - 1)]; };
    if (ranks.lower) found.lower = at(*ranks.lower);
    if (ranks.upper) found.upper = at(*ranks.upper);
  }
  double best = kInfinity;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double away = values[i] ? std::abs(*values[i] - found.estimate.value) : kInfinity;
    if (away >= best) continue;
    best = away;
    found.sample = i;
  }
  return found;
}

}  // namespace

std::optional<Spread> spread_of(const ScatterTask& task, const SampleValues& values,
                                int per_replicate, const PossibleValues& possible) {
  const auto n = static_cast<std::size_t>(per_replicate);
  const std::vector<double> all = existing(values);
  if (all.empty()) return std::nullopt;
  std::vector<double> sorted = all;
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> means, deviations;
  std::vector<std::vector<double>> replicates;
  for (std::size_t from = 0; from + n <= values.size(); from += n) {
    std::vector<double> v = existing(std::span(values).subspan(from, n));
    if (v.empty()) continue;
    const Moments m = moments(v);
    means.push_back(m.mean);
    deviations.push_back(std::sqrt(m.variance));
    std::sort(v.begin(), v.end());
    replicates.push_back(std::move(v));
  }
  const Moments m = moments(all);
  Spread spread{pooled(m.mean, means),
                pooled(std::sqrt(m.variance), deviations),
                {},
                sorted.front(),
                sorted.back()};
  for (const double percent : task.percentiles)
    spread.percentiles.push_back(
        percentile_of(task, percent, values, sorted, replicates, possible));
  return spread;
}

Probability probability_of(std::int64_t count, std::int64_t of, double confidence) {
  return {static_cast<double>(count) / static_cast<double>(of), count, of,
          probability_interval(count, of, confidence)};
}

}  // namespace gearwright
