#include "gearwright/inspection/identify_fit.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace gearwright::detail {

namespace {

using std::numbers::pi;

// The prior distributions: x_E scatters about 0, helix angles are uniform up to 45°, and modules cover two
// decades.
constexpr double kShiftScatter = 0.5;
constexpr double kHelixRange = pi / 4;
// Information of the prior of the helix angle, 1/rad². Without readings, √(2π)·σ is the whole range.
// Because readings change with β² only, they contain less information than the prior near β = 0.
constexpr double kHelixInformation = 2 * pi / (kHelixRange * kHelixRange);
constexpr double kLogModuleRange = 5.0;
constexpr int kMostSteps = 12;

double& unknown(GearNumbers& g, int which) {
  return which == 0 ? g.shift : which == 1 ? g.beta : g.module;
}

// Step of the difference quotients, which is small compared with the resolution of readings.
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
  // Values that are not fitted have rows of the unit matrix.
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
  // The scatter of rough readings is proportional to the module, so the same deviation in mm is less
  // significant if the module is larger.
  for (const Observation& o : readings)
    if (!o.exact()) log_prior -= std::log(g.module);
  fit.log_evidence = log_prior - square_sum(r) / 2 + double(n) / 2 * std::log(2 * pi) -
                     std::log(normal.determinant()) / 2;
  return fit;
}

}  // namespace gearwright::detail
