#include "gearwright/inspection/identify_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>

#include <Eigen/LU>

#include "gearwright/generation/outline.hpp"
#include "gearwright/math/involute.hpp"

namespace gearwright::detail {

namespace {

using std::numbers::pi;

// Usual uncertainties of readings at 95 %.
constexpr double kLeadUncertainty = 0.02;  // relative, of a lead measured by rolling over paper
constexpr double kHelixUncertainty = 0.5;  // degrees, of a helix angle
// Standard deviations of rough readings, in modules.
constexpr double kTipScatter = 0.15;  // due to wear, tip shortening and x − x_E
constexpr double kRootScatter = 0.04;
constexpr double kDistanceScatter = 0.5;  // due to the profile shift of the mating gear
// Addenda of usual racks in modules, each with its share of all gears. Stub teeth are rare.
struct Addendum {
  double length, share;
};
constexpr std::array kAddenda{Addendum{1.0, 0.97}, Addendum{0.8, 0.03}};
constexpr std::array kDedenda{1.25, 1.4, 1.0, 1.157, 1.2, 1.35};

double nearest_miss(std::span<const double> choices, double value) {
  double least = value - choices.front();
  for (const double c : choices)
    if (std::abs(value - c) < std::abs(least)) least = value - c;
  return least;
}

// Returns the deviation of the tip from the tip that the likeliest usual addendum gives, in standard
// deviations. `addendum` and `sigma` are in modules. For a rare addendum, the square of the result
// includes −2 log(share/share of full teeth) [T10.40].
double tip_residual(double addendum, double sigma) {
  double least = std::numeric_limits<double>::infinity();
  for (const Addendum& usual : kAddenda) {
    const double miss = (addendum - usual.length) / sigma;
    const double rare = 2 * std::log(kAddenda.front().share / usual.share);
    const double one = rare > 0.0 ? std::sqrt(miss * miss + rare) : miss;
    if (std::abs(one) < std::abs(least)) least = one;
  }
  return least;
}

struct Base {
  double d, d_b, cos_b, s_bt, p_bt, sigma;
};

Base base_of(const GearNumbers& g) {
  const double z = std::abs(g.teeth), sigma = side_of(g.teeth);
  const double cos_beta = std::cos(g.beta), tan_alpha = std::tan(g.alpha);
  const double alpha_t = std::atan(tan_alpha / cos_beta);
  Base b{};
  b.sigma = sigma;
  b.d = z * g.module / cos_beta;
  b.d_b = b.d * std::cos(alpha_t);
  const double sin_b = std::sin(g.beta) * std::cos(g.alpha);
  b.cos_b = std::sqrt(1 - sin_b * sin_b);
  const double s_n = g.module * (pi / 2 + 2 * g.shift * tan_alpha);
  b.s_bt = b.d_b * (s_n / cos_beta / b.d + sigma * involute(alpha_t));
  b.p_bt = pi * b.d_b / z;
  return b;
}

}  // namespace

std::vector<Observation> observations(const IdentifyProblem& p) {
  std::vector<Observation> list;
  for (const SpanReading& s : p.spans)
    list.push_back({Reading::span, double(s.teeth), s.value, p.span_uncertainty / kSigmas});
  for (const DiameterReading& b : p.balls)
    list.push_back({Reading::over_balls, b.tool, b.value, p.balls_uncertainty / kSigmas});
  if (p.lead.value) {
    const double lead = std::abs(*p.lead.value);
    const double u = p.lead.uncertainty.value_or(kLeadUncertainty * lead);
    list.push_back({Reading::lead, 0, 1 / lead, u / kSigmas / (lead * lead)});
  }
  if (p.helix.value) {
    const double u = p.helix.uncertainty.value_or(Angle::degrees(kHelixUncertainty)).rad();
    list.push_back({Reading::helix_angle, 0, std::abs(p.helix.value->rad()), u / kSigmas});
  }
  const auto rough = [&](Reading kind, double tool, const MaybeReading<double>& r) {
    if (r.value) list.push_back({kind, tool, *r.value, r.uncertainty.value_or(kLength) / kSigmas});
  };
  rough(Reading::tip_diameter, 0, p.tip);
  rough(Reading::root_diameter, 0, p.root);
  if (p.mating_teeth) rough(Reading::center_distance, *p.mating_teeth, p.distance);
  return list;
}

std::optional<double> reading_of(const GearNumbers& g, const Observation& o) {
  const double z = std::abs(g.teeth);
  switch (o.kind) {
    case Reading::lead: return std::sin(g.beta) / (pi * z * g.module);
    case Reading::helix_angle: return g.beta;
    default: break;
  }
  const Base b = base_of(g);
  switch (o.kind) {
    case Reading::span:
      if (b.sigma < 0) return b.cos_b * (o.tool * b.p_bt - b.s_bt);
      return b.cos_b * ((o.tool - 1) * b.p_bt + b.s_bt);
    case Reading::over_balls: {
      const double inv = b.sigma * (o.tool / (b.d_b * b.cos_b) - pi / z + b.s_bt / b.d_b);
      if (!(inv > 0.0) || inv > 10.0) return std::nullopt;
      const double d_K = b.d_b / std::cos(inverse_involute(inv));
      const double across = g.teeth % 2 == 0 ? 1.0 : std::cos(pi / (2 * z));
      return d_K * across + b.sigma * o.tool;
    }
    case Reading::tip_diameter:
      return b.d + b.sigma * 2 * g.module * (kAddenda.front().length + g.shift);
    case Reading::root_diameter: return b.d - b.sigma * 2 * g.module * (kDedenda.front() - g.shift);
    case Reading::center_distance: {
      const double sum =
          o.tool * g.teeth > 0 ? z + std::abs(o.tool) : std::abs(z - std::abs(o.tool));
      return sum * g.module / std::cos(g.beta) / 2;
    }
    default: return std::nullopt;
  }
}

std::optional<double> residual(const GearNumbers& g, const Observation& o) {
  const auto read = reading_of(g, o);
  if (!read) return std::nullopt;
  const double side = side_of(g.teeth);
  const double off = (o.value - *read) / g.module;  // modules
  const double sigma = o.sigma / g.module;
  switch (o.kind) {
    case Reading::tip_diameter:
      return tip_residual(kAddenda.front().length + side * off / 2,
                          std::hypot(kTipScatter, sigma / 2));
    case Reading::root_diameter:
      return nearest_miss(kDedenda, kDedenda.front() - side * off / 2) /
             std::hypot(kRootScatter, sigma / 2);
    case Reading::center_distance: return off / std::hypot(kDistanceScatter, sigma);
    default: return (o.value - *read) / o.sigma;
  }
}

namespace {

using std::numbers::pi;

// In the prior distributions, x_E scatters about 0, helix angles are uniform up to 45°, and modules
// cover two decades.
constexpr double kShiftScatter = 0.5;
constexpr double kHelixRange = pi / 4;
// Inverse variance of the prior of the helix angle, 1/rad². The standard deviation σ of this prior
// follows from √(2π) σ = kHelixRange. Readings other than a lead and a helix angle depend on β².
// Near β = 0, they therefore hardly restrict the helix angle.
constexpr double kHelixInformation = 2 * pi / (kHelixRange * kHelixRange);
constexpr double kLogModuleRange = 5.0;
constexpr int kMostSteps = 12;

double& unknown(GearNumbers& g, int which) {
  return which == 0 ? g.shift : which == 1 ? g.beta : g.module;
}

// Returns the step of the difference quotients, small relative to the resolution of readings.
double step_of(const GearNumbers& g, int which) { return which == 2 ? 1e-6 * g.module : 1e-6; }

// Computes the residuals. The last residual belongs to the prior of the shift. Returns false if a
// residual is undefined.
bool residuals(const GearNumbers& g, const std::vector<Observation>& readings,
               std::vector<double>& r) {
  r.clear();
  for (const Observation& o : readings) {
    const auto one = residual(g, o);
    if (!one || !std::isfinite(*one)) return false;
    r.push_back(*one);
  }
  r.push_back(-g.shift / kShiftScatter);
  return true;
}

double square_sum(const std::vector<double>& r) {
  return std::inner_product(r.begin(), r.end(), r.begin(), 0.0);
}

bool sane(const GearNumbers& g) {
  return std::abs(g.shift) < 4.0 && g.beta >= 0.0 && g.beta < 1.2 && g.module > 1e-3;
}

}  // namespace

std::optional<RackFit> fit_rack(const GearNumbers& start, const Unknowns& unknowns,
                                const std::vector<Observation>& readings) {
  const std::array free{unknowns.shift, unknowns.helix, unknowns.module};
  const int n = static_cast<int>(std::count(free.begin(), free.end(), true));
  GearNumbers g = start;
  std::vector<double> r, moved;
  if (!residuals(g, readings, r)) return std::nullopt;
  // The matrix starts as a unit matrix. The rows of values that are not fitted stay unchanged.
  Eigen::Matrix3d normal = Eigen::Matrix3d::Identity();
  std::array<std::vector<double>, 3> slope;  // slopes of the predicted readings, in units of σ
  for (int step = 0; step < kMostSteps; ++step) {
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    for (int j = 0; j < 3; ++j) {
      auto& column = slope[static_cast<std::size_t>(j)];
      column.assign(r.size(), 0.0);
      if (!free[static_cast<std::size_t>(j)]) continue;
      GearNumbers beside = g;
      const double h = step_of(g, j);
      unknown(beside, j) += h;
      if (!residuals(beside, readings, moved)) return std::nullopt;
      for (std::size_t i = 0; i < r.size(); ++i) {
        column[i] = (r[i] - moved[i]) / h;
        gradient[j] += column[i] * r[i];
      }
    }
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) {
        const auto& a = slope[static_cast<std::size_t>(j)];
        const auto& b = slope[static_cast<std::size_t>(k)];
        const bool fitted = free[static_cast<std::size_t>(j)] && free[static_cast<std::size_t>(k)];
        normal(j, k) = fitted ? std::inner_product(a.begin(), a.end(), b.begin(), 0.0) : j == k;
      }
    }
    if (unknowns.helix) normal(1, 1) += kHelixInformation;
    if (!(normal.determinant() > 0.0)) return std::nullopt;
    const Eigen::Vector3d delta = normal.inverse() * gradient;
    if (!delta.allFinite()) return std::nullopt;
    const double before = square_sum(r);
    bool better = false;
    for (double damped = 1.0; damped > 1e-3 && !better; damped /= 4) {
      GearNumbers next = g;
      for (int j = 0; j < 3; ++j) unknown(next, j) += damped * delta[j];
      if (!sane(next) || !residuals(next, readings, moved)) continue;
      better = square_sum(moved) < before * (1 + 1e-12);
      if (!better) continue;
      g = next;
      r = moved;
    }
    if (!better || before - square_sum(r) < 1e-6) break;
  }
  const Eigen::Matrix3d covariance = normal.inverse();
  RackFit fit{g, 0.0, 0.0, 0.0, 0.0, n, 0.0};
  for (std::size_t i = 0; i < readings.size(); ++i)
    if (readings[i].exact()) fit.misfit += r[i] * r[i];
  double log_prior = -std::log(kShiftScatter * std::sqrt(2 * pi));
  if (free[0]) fit.sigma_shift = std::sqrt(covariance(0, 0));
  if (free[1]) {
    fit.sigma_helix = std::sqrt(covariance(1, 1));
    log_prior -= std::log(kHelixRange);
  }
  if (free[2]) {
    fit.sigma_module = std::sqrt(covariance(2, 2));
    log_prior -= std::log(kLogModuleRange * g.module);
  }
  // The scatter of a rough reading is proportional to the module, so the probability density of the
  // reading has the factor 1/m_n.
  for (const Observation& o : readings)
    if (!o.exact()) log_prior -= std::log(g.module);
  fit.log_evidence = log_prior - square_sum(r) / 2 + double(n) / 2 * std::log(2 * pi) -
                     std::log(normal.determinant()) / 2;
  return fit;
}

}  // namespace gearwright::detail
