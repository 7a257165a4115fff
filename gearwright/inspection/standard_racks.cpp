
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "gearwright/base/units.hpp"
#include "gearwright/inspection/identify_model.hpp"

namespace gearwright::detail {

namespace {

// Modules of ISO 54, extended to smaller modules.
constexpr std::array kSeries1{0.3, 0.4, 0.5, 0.6, 0.8, 1.0,  1.25, 1.5,  2.0,  2.5,  3.0, 4.0,
                              5.0, 6.0, 8.0, 10., 12., 16.0, 20.0, 25.0, 32.0, 40.0, 50.0};
constexpr std::array kSeries2{0.35, 0.45, 0.55, 0.7,  0.75, 0.9,  1.125, 1.375,
                              1.75, 2.25, 2.75, 3.5,  4.5,  5.5,  6.5,   7.0,
                              9.0,  11.,  14.0, 18.0, 22.0, 28.0, 36.0,  45.0};
constexpr std::array kPitches{1.0,  1.25, 1.5,  1.75, 2.0,  2.25, 2.5,  3.0,  3.5,  4.0,  5.0,
                              6.0,  7.0,  8.0,  9.0,  10.0, 11.0, 12.0, 13.0, 14.0, 16.0, 18.0,
                              20.0, 22.0, 24.0, 26.0, 28.0, 30.0, 32.0, 36.0, 40.0, 48.0, 64.0};
// Pressure angles in degrees, each with its share of all gears.
using Share = std::pair<double, double>;
constexpr std::array kMetricAngles{Share{20, 0.86},   Share{14.5, 0.02}, Share{15, 0.04},
                                   Share{17.5, 0.02}, Share{22.5, 0.02}, Share{25, 0.03},
                                   Share{30, 0.01}};
constexpr std::array kInchAngles{Share{20, 0.66}, Share{14.5, 0.24}, Share{25, 0.08},
                                 Share{22.5, 0.02}};
constexpr double kShare1 = 0.64, kShare2 = 0.21, kShareInch = 0.15;

void add(std::vector<StandardRack>& racks, std::span<const double> sizes, ModuleSeries series,
         double share, std::span<const Share> angles) {
  const bool inch = series == ModuleSeries::diametral_pitch;
  for (const double size : sizes) {
    for (const auto& [degrees, of_angle] : angles)
      racks.push_back({inch ? kMmPerInch / size : size, degrees * kRadPerDeg, series,
                       inch ? std::optional(size) : std::nullopt,
                       std::log(share * of_angle / static_cast<double>(sizes.size()))});
  }
}

}  // namespace

const std::vector<StandardRack>& standard_racks() {
  static const std::vector<StandardRack> kRacks = [] {
    std::vector<StandardRack> racks;
    add(racks, kSeries1, ModuleSeries::iso54_1, kShare1, kMetricAngles);
    add(racks, kSeries2, ModuleSeries::iso54_2, kShare2, kMetricAngles);
    add(racks, kPitches, ModuleSeries::diametral_pitch, kShareInch, kInchAngles);
    return racks;
  }();
  return kRacks;
}

namespace {

GearNumbers numbers_of(const IdentifiedGear& g) {
  return {g.teeth, g.normal_module, g.normal_pressure_angle.rad(), std::abs(g.helix_angle.rad()),
          g.generating_shift};
}

// Returns possible next measurements, which are the helix angle, and spans and balls that suit the
// likeliest gear.
std::vector<Observation> menu(const IdentifyProblem& p, const IdentifiedGear& first) {
  const double m = first.normal_module;
  std::vector<Observation> list;
  if (!p.lead.value && !p.helix.value && !p.helix_angle)
    list.push_back({Reading::helix_angle, 0, 0, 0.5 * kRadPerDeg / kSigmas});
  const GearNumbers g = numbers_of(first);
  const double middle = std::abs(g.teeth) * std::cos(g.alpha) * std::tan(g.alpha);
  const bool plane = p.teeth > 0 || g.beta == 0.0;
  for (int k = 1; plane && k <= std::abs(p.teeth) / 2; ++k) {
    const Observation span{Reading::span, double(k), 0, p.span_uncertainty / kSigmas};
    // Only spans with contacts near the reference cylinder are suitable.
    const double off = *reading_of(g, span) / m - middle;
    const bool read = std::any_of(p.spans.begin(), p.spans.end(),
                                  [&](const SpanReading& s) { return s.teeth == k; });
    if (std::abs(off) < 4.0 && !read) list.push_back(span);
  }
  for (const double size : {1.5, 1.75, 2.0}) {
    const Observation balls{Reading::over_balls, std::round(4 * size * m) / 4, 0,
                            p.balls_uncertainty / kSigmas};
    const bool read = std::any_of(p.balls.begin(), p.balls.end(), [&](const DiameterReading& b) {
      return std::abs(b.tool - balls.tool) < 0.1 * m;
    });
    if (!read && balls.tool > 0.0) list.push_back(balls);
  }
  return list;
}

// The reading that a gear predicts, with its standard deviation, which includes that of the reading.
struct Prediction {
  double value, sigma;
};

std::optional<Prediction> predicted(const IdentifiedGear& gear, const Observation& o) {
  const GearNumbers g = numbers_of(gear);
  const auto value = reading_of(g, o);
  if (!value) return std::nullopt;
  double variance = o.sigma * o.sigma;
  const auto add = [&](double GearNumbers::*unknown, double uncertainty) {
    if (uncertainty <= 0.0) return;
    GearNumbers beside = g;
    beside.*unknown += uncertainty;
    if (const auto moved = reading_of(beside, o))
      variance += (*moved - *value) * (*moved - *value) / (kSigmas * kSigmas);
  };
  add(&GearNumbers::shift, gear.shift_uncertainty);
  add(&GearNumbers::beta, gear.helix_uncertainty.rad());
  add(&GearNumbers::module, gear.module_uncertainty);
  return Prediction{*value, std::sqrt(variance)};
}

// Returns the common part of two normal distributions, from 0 if they are apart to 1 if they are
// equal [T10.42].
double common_part(const Prediction& a, const Prediction& b) {
  const double sum = a.sigma * a.sigma + b.sigma * b.sigma, apart = a.value - b.value;
  return std::sqrt(2 * a.sigma * b.sigma / sum) * std::exp(-apart * apart / (4 * sum));
}

}  // namespace

std::optional<NextMeasurement> next_measurement(const IdentifyProblem& problem,
                                                const std::vector<IdentifiedGear>& candidates) {
  constexpr double kWorthDeciding = 0.01;
  // Equal distributions whose mean values differ by the uncertainty have this common part.
  constexpr double kDistinct = 0.6;
  if (candidates.empty()) return std::nullopt;
  double best = 0.0;
  std::optional<NextMeasurement> next;
  for (const Observation& o : menu(problem, candidates.front())) {
    const auto first = predicted(candidates.front(), o);
    if (!first) continue;
    double separated = 0.0, most = 0.0;
    NextMeasurement one{o.kind, o.tool, {}, {}, 0, {}};
    for (std::size_t i = 1; i < candidates.size(); ++i) {
      const double likelihood = candidates[i].likelihood;
      const auto other = predicted(candidates[i], o);
      if (likelihood < kWorthDeciding || !other) continue;
      const double common = common_part(*first, *other);
      separated += likelihood * (1 - common);
      if (common >= kDistinct) continue;
      one.separates.push_back(static_cast<int>(i));
      if (likelihood <= most) continue;
      most = likelihood;
      one.rival = static_cast<int>(i);
      const double unit = o.kind == Reading::helix_angle ? kDegPerRad : 1.0;
      one.expect = {first->value * unit, other->value * unit};
      one.spread = {kSigmas * first->sigma * unit, kSigmas * other->sigma * unit};
    }
    if (one.separates.empty() || separated <= best) continue;
    best = separated;
    next = std::move(one);
  }
  return next;
}

}  // namespace gearwright::detail
