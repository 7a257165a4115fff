#include "gearwright/scatter/scatter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/parallel.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/math/sobol.hpp"
#include "gearwright/scatter/loosening.hpp"
#include "gearwright/scatter/sample_points.hpp"
#include "gearwright/scatter/worst_case.hpp"

namespace gearwright {

namespace {

constexpr std::size_t kBlock = 64;  // samples that a thread takes at once
// A quantity with a smaller standard deviation varies by rounding only.
constexpr double kRoundingAngle = 1e-12;  // rad
constexpr double kRoundingShare = 1e-9;

bool is_share(std::size_t quantity) {
  const auto q = static_cast<ScatterQuantity>(quantity);
  return q == ScatterQuantity::along_face || q == ScatterQuantity::along_profile ||
         q == ScatterQuantity::edge_share;
}

// Members of all samples, by a function of replicate and n that gives x.
template <class F>
std::vector<ScatterSample> members_of(const ContactSetup& setup, const ScatterTask& task,
                                      const F& x_at) {
  const auto n = static_cast<std::size_t>(task.samples);
  std::vector<ScatterSample> samples(n * static_cast<std::size_t>(task.replicates));
  parallel_for((samples.size() + kBlock - 1) / kBlock,
               [&](std::size_t block) {
                 const std::size_t end = std::min(samples.size(), (block + 1) * kBlock);
                 for (std::size_t i = block * kBlock; i < end; ++i) {
                   ScatterSample& sample = samples[i];
                   sample.x = x_at(static_cast<int>(i / n), static_cast<std::uint32_t>(i % n));
                   sample.member = member_at(setup, deviation_at(setup, task.tolerances, sample.x),
                                             task.member);
                   count_step(task.progress);
                 }
               },
               task.threads);
  return samples;
}

// x of A with the coordinates of a group from B.
std::vector<double> mixed(const ScatterTask& task, const ToleranceGroup& group,
                          std::vector<double> a, const std::vector<double>& b) {
  std::size_t from = 0;
  for (std::size_t t = 0; t < task.tolerances.size(); ++t) {
    const auto count = static_cast<std::size_t>(task.tolerances[t].coordinates());
    if (std::find(group.tolerances.begin(), group.tolerances.end(), t) != group.tolerances.end())
      std::copy_n(b.begin() + static_cast<std::ptrdiff_t>(from), count,
                  a.begin() + static_cast<std::ptrdiff_t>(from));
    from += count;
  }
  return a;
}

// The values of one quantity and their indices, for replicate r or (r < 0) all of them, of the
// samples that keep contact.
struct Values {
  std::vector<double> value;
  std::vector<std::size_t> sample;
};

Values values_of(const std::vector<ScatterSample>& samples, std::size_t quantity, std::size_t from,
                 std::size_t count) {
  Values v;
  for (std::size_t i = from; i < from + count; ++i) {
    const double value = samples[i].member.value[quantity];
    if (samples[i].member.lost || std::isnan(value)) continue;
    v.value.push_back(value);
    v.sample.push_back(i);
  }
  return v;
}

Percentile percentile_of(const ScatterTask& task, double percent, const Values& all,
                         const std::vector<double>& sorted,
                         const std::vector<std::vector<double>>& sorted_replicates) {
  const double p = percent / 100.0;
  std::vector<double> each;
  for (const auto& r : sorted_replicates) each.push_back(quantile(r, p));
  Percentile found{percent, estimate(each), {}, {}, 0};
  if (task.sampling == Sampling::sobol && found.estimate.standard_error) {
    const ConfidenceInterval i = interval(found.estimate, each.size(), task.confidence);
    found.lower = i.lower;
    found.upper = i.upper;
  } else {
    const auto ranks = quantile_ranks(static_cast<std::int64_t>(sorted.size()), p, task.confidence);
    const auto at = [&](std::int64_t rank) { return sorted[static_cast<std::size_t>(rank - 1)]; };
    if (ranks.lower) found.lower = at(*ranks.lower);
    if (ranks.upper) found.upper = at(*ranks.upper);
  }
  double best = std::abs(all.value[0] - found.estimate.value);
  found.sample = all.sample[0];
  for (std::size_t i = 1; i < all.value.size(); ++i) {
    const double away = std::abs(all.value[i] - found.estimate.value);
    if (away >= best) continue;
    best = away;
    found.sample = all.sample[i];
  }
  return found;
}

std::optional<Spread> spread_of(const ScatterTask& task, const std::vector<ScatterSample>& samples,
                                std::size_t quantity) {
  const auto n = static_cast<std::size_t>(task.samples);
  const Values all = values_of(samples, quantity, 0, samples.size());
  if (all.value.empty()) return std::nullopt;
  std::vector<double> sorted = all.value;
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> means, deviations;
  std::vector<std::vector<double>> replicates;
  for (std::size_t r = 0; r < static_cast<std::size_t>(task.replicates); ++r) {
    Values v = values_of(samples, quantity, r * n, n);
    if (v.value.empty()) continue;
    const Moments m = moments(v.value);
    means.push_back(m.mean);
    deviations.push_back(std::sqrt(m.variance));
    std::sort(v.value.begin(), v.value.end());
    replicates.push_back(std::move(v.value));
  }
  Spread spread{estimate(means), estimate(deviations), {}, sorted.front(), sorted.back()};
  for (const double percent : task.percentiles)
    spread.percentiles.push_back(percentile_of(task, percent, all, sorted, replicates));
  return spread;
}

template <class F>
Probability probability_of(const std::vector<ScatterSample>& samples, double confidence,
                           const F& is) {
  std::int64_t count = 0;
  for (const ScatterSample& s : samples)
    if (is(s.member)) ++count;
  const auto of = static_cast<std::int64_t>(samples.size());
  return {static_cast<double>(count) / static_cast<double>(of), count, of,
          probability_interval(count, of, confidence)};
}

// One quantity of one replicate. A sample that loses contact has no value.
std::vector<double> column(const std::vector<ScatterSample>& samples, std::size_t quantity,
                           std::size_t from, std::size_t count) {
  std::vector<double> v;
  for (std::size_t i = from; i < from + count; ++i) v.push_back(samples[i].member.value[quantity]);
  return v;
}

std::optional<IndexEstimates> indices_of(
    const ScatterTask& task, const std::vector<ScatterSample>& a,
    const std::vector<ScatterSample>& b,
    const std::vector<std::vector<ScatterSample>>& mixed_samples, std::size_t quantity) {
  const auto n = static_cast<std::size_t>(task.samples);
  const double rounding = is_share(quantity) ? kRoundingShare : kRoundingAngle;
  const std::size_t groups = mixed_samples.size();
  std::vector<std::vector<double>> first(groups), total(groups);
  for (std::size_t r = 0; r < static_cast<std::size_t>(task.replicates); ++r) {
    std::vector<std::vector<double>> columns;
    for (const auto& m : mixed_samples) columns.push_back(column(m, quantity, r * n, n));
    const auto found = sobol_indices(column(a, quantity, r * n, n), column(b, quantity, r * n, n),
                                     columns, rounding * rounding);
    if (!found) return std::nullopt;
    for (std::size_t g = 0; g < groups; ++g) {
      first[g].push_back(found->first[g]);
      total[g].push_back(found->total[g]);
    }
  }
  IndexEstimates e;
  for (std::size_t g = 0; g < groups; ++g) {
    e.first.push_back(estimate(first[g]));
    e.total.push_back(estimate(total[g]));
  }
  return e;
}

}  // namespace

Result<Scatter> scatter_of(const ContactSetup& setup, const ScatterTask& task) {
  GW_EXPECTS(!task.tolerances.empty() && task.samples >= 1 && task.replicates >= 1);
  GW_EXPECTS((task.samples & (task.samples - 1)) == 0);
  const int d = coordinates_of(task.tolerances);
  if (2 * d > SobolPoints::kMaxDimensions) {
    return refused("tolerances", d,
                   fmt::format("coordinates; Sobol's points are tabulated for {} of them",
                               SobolPoints::kMaxDimensions / 2));
  }
  if (auto error = check_ends(setup, task.tolerances)) return *error;
  const SamplePoints points(task);
  const auto all = static_cast<std::int64_t>(task.samples) * task.replicates;
  begin_stage(task.progress, "samples", all);
  Scatter s;
  s.samples = members_of(setup, task, [&](int r, std::uint32_t n) { return points.at(r, n); });
  const auto nowhere = [](const ScatterSample& sample) {
    return sample.member[ScatterQuantity::edge_share] == 0.0 && sample.member.lost &&
           std::isnan(sample.member[ScatterQuantity::least_play]);
  };
  if (std::all_of(s.samples.begin(), s.samples.end(), nowhere)) return nothing_touches(setup);
  for (std::size_t q = 0; q < kScatterQuantities; ++q) s.spread[q] = spread_of(task, s.samples, q);
  s.edge_contact =
      probability_of(s.samples, task.confidence, [](const FamilyMember& m) { return m.edge(); });
  s.jam =
      probability_of(s.samples, task.confidence, [](const FamilyMember& m) { return m.jams(); });
  s.contact_lost =
      probability_of(s.samples, task.confidence, [](const FamilyMember& m) { return m.lost; });
  if (task.indices) {
    begin_stage(task.progress, "samples for the indices",
                all * static_cast<std::int64_t>(task.groups.size() + 1));
    const auto other =
        members_of(setup, task, [&](int r, std::uint32_t n) { return points.of_other_half(r, n); });
    std::vector<std::vector<ScatterSample>> mixed_samples;
    for (const ToleranceGroup& group : task.groups) {
      mixed_samples.push_back(members_of(setup, task, [&](int r, std::uint32_t n) {
        return mixed(task, group, points.at(r, n), points.of_other_half(r, n));
      }));
    }
    for (std::size_t q = 0; q < kScatterQuantities; ++q)
      s.indices[q] = indices_of(task, s.samples, other, mixed_samples, q);
  }
  if (task.worst_case) {
    s.worst_peak_to_peak = worst_member(setup, task, s.samples, ScatterQuantity::peak_to_peak);
    s.worst_least_play = worst_member(setup, task, s.samples, ScatterQuantity::least_play);
  }
  if (task.loosening) s.loosening = loosening_of(setup, task);
  return s;
}

}  // namespace gearwright
