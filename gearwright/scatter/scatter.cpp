#include "gearwright/scatter/scatter.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gearwright/base/lists.hpp"
#include "gearwright/base/parallel.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/scatter/linear_share.hpp"
#include "gearwright/scatter/loaded_family.hpp"
#include "gearwright/scatter/loosening.hpp"
#include "gearwright/scatter/sample_points.hpp"
#include "gearwright/scatter/spread.hpp"
#include "gearwright/scatter/worst_case.hpp"

namespace gearwright {

namespace {

constexpr std::size_t kBlock = 64;  // samples that a thread takes at once
// A quantity whose standard deviation is below these limits varies by rounding only.
constexpr double kRoundingAngle = 1e-12;  // rad
constexpr double kRoundingShare = 1e-9;
constexpr double kRoundingLength = 1e-9;  // mm

double rounding_of(std::size_t quantity) {
  using Q = ScatterQuantity;
  switch (static_cast<Q>(quantity)) {
    case Q::along_face:
    case Q::along_profile:
    case Q::edge_share: return kRoundingShare;
    case Q::tip_clearance1:
    case Q::tip_clearance2:
    case Q::form_clearance1:
    case Q::form_clearance2: return kRoundingLength;
    default: return kRoundingAngle;
  }
}

// Returns the members of all samples. `x_at` returns x for a replicate and a sample number n.
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

// Returns the point `a` with the coordinates of `b` for the tolerances of `group`.
std::vector<double> mixed(const ScatterTask& task, const ToleranceGroup& group,
                          std::vector<double> a, const std::vector<double>& b) {
  std::size_t from = 0;
  for (std::size_t t = 0; t < task.tolerances.size(); ++t) {
    const auto count = static_cast<std::size_t>(task.tolerances[t].coordinates());
    if (is_in(t, group.tolerances))
      std::copy_n(b.begin() + static_cast<std::ptrdiff_t>(from), count,
                  a.begin() + static_cast<std::ptrdiff_t>(from));
    from += count;
  }
  return a;
}

// Returns one quantity of `count` samples, beginning with the sample `from`. The value is none for
// samples that lose contact.
SampleValues kept(const std::vector<ScatterSample>& samples, std::size_t quantity, std::size_t from,
                  std::size_t count) {
  SampleValues values(count);
  for (std::size_t i = 0; i < count; ++i)
    if (const FamilyMember& m = samples[from + i].member; !m.lost) values[i] = m.value[quantity];
  return values;
}

std::optional<IndexEstimates> indices_of(
    const ScatterTask& task, const std::vector<ScatterSample>& a,
    const std::vector<ScatterSample>& b,
    const std::vector<std::vector<ScatterSample>>& mixed_samples, std::size_t quantity) {
  const auto n = static_cast<std::size_t>(task.samples);
  const double rounding = rounding_of(quantity);
  const std::size_t groups = mixed_samples.size();
  std::vector<std::vector<double>> first(groups), total(groups);
  for (std::size_t r = 0; r < static_cast<std::size_t>(task.replicates); ++r) {
    std::vector<SampleValues> columns;
    for (const auto& m : mixed_samples) columns.push_back(kept(m, quantity, r * n, n));
    const auto found = sobol_indices(kept(a, quantity, r * n, n), kept(b, quantity, r * n, n),
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

PossibleValues possible_values(ScatterQuantity quantity) {
  switch (quantity) {
    case ScatterQuantity::peak_to_peak:
    case ScatterQuantity::harmonic1:
    case ScatterQuantity::harmonic2:
    case ScatterQuantity::harmonic3:
    case ScatterQuantity::long_period: return kNotNegative;
    case ScatterQuantity::along_face: return {-1.0, 1.0};
    case ScatterQuantity::edge_share: return {0.0, 1.0};
    default: return {};
  }
}

}  // namespace

Result<Scatter> scatter_of(const ContactSetup& setup, const ScatterTask& task) {
  GW_EXPECTS(!task.tolerances.empty() && task.samples >= 1 && task.replicates >= 1);
  GW_EXPECTS((task.samples & (task.samples - 1)) == 0);
  if (auto error = check_family(setup, task.tolerances)) return *error;
  const SamplePoints points(task);
  const auto all = static_cast<std::int64_t>(task.samples) * task.replicates;
  begin_stage(task.progress, "computing the samples", all);
  Scatter s;
  s.samples = members_of(setup, task, [&](int r, std::uint32_t n) { return points.at(r, n); });
  const auto nowhere = [](const ScatterSample& sample) {
    return sample.member[ScatterQuantity::edge_share] == 0.0 && sample.member.lost &&
           !sample.member[ScatterQuantity::least_play];
  };
  if (std::all_of(s.samples.begin(), s.samples.end(), nowhere)) return nothing_touches(setup);
  for (std::size_t q = 0; q < kScatterQuantities; ++q)
    s.spread[q] = spread_of(task, kept(s.samples, q, 0, s.samples.size()), task.samples,
                            possible_values(static_cast<ScatterQuantity>(q)));
  s.edge_contact =
      share_of(s.samples, task.confidence, [](const ScatterSample& x) { return x.member.edge(); });
  s.jam = share_of(s.samples, task.confidence, [](const ScatterSample& x) { return x.member.jam; });
  s.contact_lost =
      share_of(s.samples, task.confidence, [](const ScatterSample& x) { return x.member.lost; });
  if (task.indices) {
    begin_stage(task.progress, "computing the samples for the shares of the variance",
                all * static_cast<std::int64_t>(task.groups.size() + 1));
    const auto other =
        members_of(setup, task, [&](int r, std::uint32_t n) { return points.of_other_half(r, n); });
    std::vector<std::vector<ScatterSample>> mixed_samples;
    for (const ToleranceGroup& group : task.groups) {
      mixed_samples.push_back(members_of(setup, task, [&](int r, std::uint32_t n) {
        return mixed(task, group, points.at(r, n), points.of_other_half(r, n));
      }));
    }
    const auto linear = linear_shares(setup, task, s.samples);
    for (std::size_t q = 0; q < kScatterQuantities; ++q) {
      s.indices[q] = indices_of(task, s.samples, other, mixed_samples, q);
      if (s.indices[q]) s.indices[q]->linear_share = linear[q];
    }
  }
  if (task.worst_case) {
    s.worst_peak_to_peak = worst_member(setup, task, s.samples, ScatterQuantity::peak_to_peak);
    s.worst_least_play = worst_member(setup, task, s.samples, ScatterQuantity::least_play);
  }
  if (task.loosening) s.loosening = loosening_of(setup, task);
  if (task.load) s.loaded = loaded_spreads(setup, task, s.samples);
  if (task.density) s.density = pattern_density(setup, task, s, *task.density);
  return s;
}

std::vector<Warning> sample_warnings(const Scatter& scatter) {
  // Edge contact is reported if more than one gear pair in twenty has it.
  constexpr double kOftenEdge = 0.05;
  std::vector<Warning> warnings;
  const auto warn = [&](WarningCode code, std::string message) {
    warnings.push_back({code, std::move(message)});
  };
  if (scatter.jam.count > 0) {
    double least = 0.0;
    for (const ScatterSample& sample : scatter.samples)
      if (sample.member.jam) least = std::min(least, *sample.member[ScatterQuantity::least_play]);
    warn(WarningCode::samples_jam,
         fmt::format(
             "The gears jam in {} of {} samples. The least play of gear 2 is {:.5f} degrees.",
             scatter.jam.count, scatter.jam.of, least * kDegPerRad));
  }
  if (scatter.edge_contact.value > kOftenEdge)
    warn(WarningCode::samples_touch_edges,
         fmt::format(
             "An edge of a tooth is in contact in {} of {} samples. Edge contact causes high "
             "pressure.",
             scatter.edge_contact.count, scatter.edge_contact.of));
  if (scatter.contact_lost.count > 0)
    warn(WarningCode::samples_lose_contact,
         fmt::format("Contact is lost at some positions of {} of {} samples.",
                     scatter.contact_lost.count, scatter.contact_lost.of));
  return warnings;
}

}  // namespace gearwright
