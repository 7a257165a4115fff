#include "gearwright/scatter/uneven_teeth.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>

#include "gearwright/math/sobol.hpp"

namespace gearwright {

namespace {

constexpr int kPointsPerWave = 16;

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

void add_wave(std::array<FlankModifications, 2>& flanks, const FlankExtent& extent,
              const FormWave& wave) {
  GW_EXPECTS(wave.waves >= 1);
  const auto shape = [&](double q) {
    return 0.5 * wave.height * std::sin(std::numbers::pi * wave.waves * q + wave.phase);
  };
  const auto roll = [&](double rho) {
    return std::sqrt(std::max(0.0, rho * rho - extent.r0 * extent.r0));
  };
  const double from = roll(extent.rho_root_form);
  const double to = roll(extent.rho_tip_form);
  const auto diameter = [&](double q) {
    return 2.0 * std::hypot(extent.r0, from + 0.5 * (1.0 + q) * (to - from));
  };
  const int points = kPointsPerWave * wave.waves + 1;
  const auto place = [&](int i) { return -1.0 + 2.0 * i / (points - 1); };
  for (FlankModifications& m : flanks) {
    Topography grid;
    if (m.topography) grid = *m.topography;
    if (!m.topography) {
      grid.diameters = {2 * extent.rho_root_form, 2 * extent.rho_tip_form};
      std::sort(grid.diameters.begin(), grid.diameters.end());
      grid.heights = {-0.5 * extent.face_width, 0.5 * extent.face_width};
      grid.removed.assign(4, 0.0);
    }
    // Waves along the face and along the profile are perpendicular, so the grid is the sum of a wave over
    // its rows and a wave over its columns.
    Topography next;
    std::vector<double> along;
    for (int i = 0; i < points; ++i) along.push_back(place(i));
    if (!wave.along_face && extent.rho_tip_form < extent.rho_root_form)
      std::reverse(along.begin(), along.end());
    next.diameters = grid.diameters;
    next.heights = grid.heights;
    std::vector<double>& side = wave.along_face ? next.heights : next.diameters;
    const std::array<double, 2> ends{side.front(), side.back()};
    side.clear();
    for (const double q : along)
      side.push_back(wave.along_face ? 0.5 * extent.face_width * q : diameter(q));
    side.front() = ends[0];
    side.back() = ends[1];
    for (std::size_t i = 0; i < next.diameters.size(); ++i) {
      for (std::size_t j = 0; j < next.heights.size(); ++j) {
        const std::size_t row = wave.along_face ? i : 0;
        const std::size_t column = wave.along_face ? 0 : j;
        next.removed.push_back(grid.removed[row * grid.heights.size() + column] +
                               shape(along[wave.along_face ? j : i]));
      }
    }
    m.topography = std::make_shared<const Topography>(std::move(next));
  }
}

}  // namespace gearwright
