#include "gearwright/scatter/uneven_teeth.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>

#include "gearwright/math/sobol.hpp"

namespace gearwright {

namespace {

double range_of(const std::vector<double>& v) {
  const auto [least, greatest] = std::minmax_element(v.begin(), v.end());
  return *greatest - *least;
}

// The greatest step from a tooth to the next one, around the gear.
double greatest_step(const std::vector<double>& v) {
  double step = 0.0;
  for (std::size_t k = 0; k < v.size(); ++k)
    step = std::max(step, std::abs(v[(k + 1) % v.size()] - v[k]));
  return step;
}

// A random walk that closes after one turn, with mean 0.
std::vector<double> closed_walk(std::size_t teeth, std::uint64_t key) {
  std::vector<double> walk(teeth);
  double at = 0.0;
  double mean_step = 0.0;
  std::vector<double> steps;
  for (std::size_t k = 0; k < teeth; ++k) {
    steps.push_back(random_unit(key, k) - 0.5);
    mean_step += steps.back() / static_cast<double>(teeth);
  }
  double mean = 0.0;
  for (std::size_t k = 0; k < teeth; ++k) {
    walk[k] = at;
    mean += at / static_cast<double>(teeth);
    at += steps[k] - mean_step;
  }
  for (double& w : walk) w -= mean;
  return walk;
}

}  // namespace

std::vector<double> uneven_pitch(const Gear& gear, const VaryingPitch& tolerance, double share,
                                 double phase, double eccentric) {
  GW_EXPECTS(share >= 0.0 && eccentric >= 0.0 && eccentric <= 1.0);
  const auto teeth = static_cast<std::size_t>(std::abs(gear.spec.teeth));
  std::uint64_t key = hash64(static_cast<std::uint64_t>(tolerance.gear));
  for (const double x : {share, phase, eccentric}) {
    std::uint64_t bits;  // std::bit_cast is missing in the standard library of the browser build
    std::memcpy(&bits, &x, sizeof bits);
    key = hash64(key ^ bits);
  }
  const std::vector<double> walk = closed_walk(teeth, key);
  const double walk_range = range_of(walk);
  const auto sum = [&](double wave, double random) {
    std::vector<double> v(teeth);
    for (std::size_t k = 0; k < teeth; ++k) {
      const double turn =
          2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(teeth);
      v[k] = 0.5 * wave * std::sin(turn + phase) +
             (walk_range > 0.0 ? random * walk[k] / walk_range : 0.0);
    }
    return v;
  };
  std::vector<double> v = sum(eccentric, 1.0 - eccentric);
  const double range = range_of(v);
  if (!(range > 0.0)) return std::vector<double>(teeth, 0.0);
  const double limit = std::min(share * tolerance.total / range,
                                tolerance.single / std::max(greatest_step(v), 1e-300));
  const double radius = std::abs(gear.reference_diameter) / 2;
  for (double& e : v) e *= limit / radius;
  return v;
}

}  // namespace gearwright
