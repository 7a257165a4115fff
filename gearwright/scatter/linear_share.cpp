#include "gearwright/scatter/linear_share.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/parallel.hpp"

namespace gearwright {

namespace {

constexpr double kWideStep = 1.0 / 16, kStep = 1.0 / 64;  // relative to w_i
// The second difference with kStep is divided by the second difference with kWideStep. The ratio is
// 1/16 for a smooth function and 1/4 at a kink. A ratio above kBend indicates a kink.
constexpr double kBend = 1.0 / 8;
// A kink is ignored if its change of slope, multiplied by w_i, is at most this fraction of the
// standard deviation of the quantity. Such a kink explains at most 0.5 % of the variance.
constexpr double kSmallBend = 0.5;
// A second difference below this value, rad, is a rounding error of the peak to peak. Other
// quantities are more accurate.
constexpr double kRoundingBend = 4e-12;

// True if the member is a continuous function of the coordinates at x = 0.
bool is_continuous(const ScatterTolerance& t) {
  return !std::holds_alternative<VaryingWave>(t.of) && !std::holds_alternative<VaryingPitch>(t.of);
}

struct Probe {
  std::vector<double> x;
  FamilyMember member{};
};

// The members at which one coordinate differs from 0. They give the derivatives with respect to
// this coordinate. For a tolerance without derivatives, they show whether it changes a quantity.
struct Probes {
  std::size_t coordinate;
  double half_width = 0.0;  // w_i; 0 for a tolerance without derivatives
  std::vector<Probe> at;    // at −kWideStep, −kStep, kStep, kWideStep; or at two typical points
};

std::vector<Probes> probes_of(const ScatterTask& task) {
  std::vector<Probes> all;
  const auto zero = std::vector<double>(static_cast<std::size_t>(coordinates_of(task.tolerances)));
  std::size_t from = 0;
  for (const ScatterTolerance& t : task.tolerances) {
    const auto count = static_cast<std::size_t>(t.coordinates());
    if (!is_continuous(t)) {
      Probes& probes = all.emplace_back(Probes{from, 0.0, {}});
      for (const double u : {0.25, 0.75}) {
        const auto value = t.at(std::array{u, u, u});
        Probe& probe = probes.at.emplace_back(Probe{zero});
        std::copy_n(value.begin(), count, probe.x.begin() + static_cast<std::ptrdiff_t>(from));
      }
    } else if (t.distribution.varies()) {
      for (std::size_t k = 0; k < count; ++k) {
        const auto [lo, hi] = t.side(static_cast<int>(k));
        Probes& probes = all.emplace_back(Probes{from + k, 0.5 * (hi - lo), {}});
        for (const double step : {-kWideStep, -kStep, kStep, kWideStep})
          probes.at.emplace_back(Probe{zero}).x[from + k] = step * probes.half_width;
      }
    }
    from += count;
  }
  return all;
}

bool teeth_exist(const ContactSetup& setup, const ScatterTask& task) {
  std::vector<ScatterTolerance> narrow;
  for (ScatterTolerance t : task.tolerances) {
    const double step = kWideStep * 0.5 * (t.distribution.greatest() - t.distribution.least());
    if (is_continuous(t)) t.distribution = Distribution::of({{-step, step}}).value();
    narrow.push_back(std::move(t));
  }
  return !check_ends(setup, narrow);
}

// Returns ∂f/∂x for one coordinate. Returns none if f has a kink at x = 0, if f has no value at a
// probe, or if a tolerance without derivatives changes f.
std::optional<double> slope_of(const Probes& probes, double drawn, std::size_t quantity,
                               double deviation) {
  std::vector<double> f;
  for (const Probe& probe : probes.at) {
    if (!probe.member.value[quantity]) return std::nullopt;
    f.push_back(*probe.member.value[quantity]);
  }
  if (probes.half_width == 0.0) {
    const bool same = f[0] == drawn && f[1] == drawn;
    return same ? std::optional(0.0) : std::nullopt;
  }
  const double bend = std::abs(f[1] - 2 * drawn + f[2]);
  const double wide_bend = std::abs(f[0] - 2 * drawn + f[3]);
  const double small = std::max(kRoundingBend, kStep * kSmallBend * deviation);
  if (bend > small && bend > kBend * wide_bend) return std::nullopt;
  return (f[2] - f[1]) / (2 * kStep * probes.half_width);
}

}  // namespace

QuantityGradients gradients_as_drawn(const ContactSetup& setup, const ScatterTask& task,
                                     const std::array<double, kScatterQuantities>& deviation) {
  QuantityGradients gradients;
  if (!teeth_exist(setup, task)) return gradients;
  std::vector<Probes> all = probes_of(task);
  const auto dimensions = static_cast<std::size_t>(coordinates_of(task.tolerances));
  const auto compute = [&](Probe& probe) {
    probe.member = member_at(setup, deviation_at(setup, task.tolerances, probe.x), task.member);
  };
  Probe drawn{std::vector<double>(dimensions)};
  compute(drawn);
  std::vector<Probe*> list;
  for (Probes& probes : all)
    for (Probe& probe : probes.at) list.push_back(&probe);
  parallel_for(
      list.size(), [&](std::size_t i) { compute(*list[i]); }, task.threads);
  for (std::size_t q = 0; q < kScatterQuantities; ++q) {
    if (!drawn.member.value[q]) continue;
    std::vector<double> g(dimensions);
    const bool exists = std::all_of(all.begin(), all.end(), [&](const Probes& probes) {
      const auto slope = slope_of(probes, *drawn.member.value[q], q, deviation[q]);
      if (slope) g[probes.coordinate] = *slope;
      return slope.has_value();
    });
    if (exists) gradients[q] = std::move(g);
  }
  return gradients;
}

std::array<std::optional<double>, kScatterQuantities> linear_shares(
    const ContactSetup& setup, const ScatterTask& task, const std::vector<ScatterSample>& samples) {
  std::array<double, kScatterQuantities> variance{};
  const auto values_of = [&](std::size_t q, const auto& value) {
    std::vector<double> values;
    for (const ScatterSample& s : samples)
      if (s.member.value[q]) values.push_back(value(s));
    return values;
  };
  for (std::size_t q = 0; q < kScatterQuantities; ++q) {
    const auto f = values_of(q, [q](const ScatterSample& s) { return *s.member.value[q]; });
    if (!f.empty()) variance[q] = moments(f).variance;
  }
  std::array<double, kScatterQuantities> deviation{};
  std::transform(variance.begin(), variance.end(), deviation.begin(),
                 [](double v) { return std::sqrt(v); });
  const QuantityGradients gradients = gradients_as_drawn(setup, task, deviation);
  std::array<std::optional<double>, kScatterQuantities> shares;
  for (std::size_t q = 0; q < kScatterQuantities; ++q) {
    if (!gradients[q] || !(variance[q] > 0.0)) continue;
    const auto linear = values_of(q, [&g = *gradients[q]](const ScatterSample& s) {
      double sum = 0.0;
      for (std::size_t i = 0; i < g.size(); ++i) sum += g[i] * s.x[i];
      return sum;
    });
    shares[q] = moments(linear).variance / variance[q];
  }
  return shares;
}

}  // namespace gearwright
