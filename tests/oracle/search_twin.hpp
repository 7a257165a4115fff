// A search as input for both the engine and the plain search, and random searches of all kinds that
// both support.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include "gearwright/design/search.hpp"
#include "tests/oracle/plain_search.hpp"

namespace gearwright::oracle {

using Real = long double;

/// A search in both forms. Lengths are in mm.
struct Twin {
  PlainProblem plain;
  std::vector<double> modules{2.0};
  std::array<double, 2> ratio{1.9, 2.1};
  std::array<int, 2> pinion_teeth{20, 24};
  std::array<double, 2> center_distance{65.0, 67.0};
  bool coprime = false;
};

inline SearchProblem engine_problem(const Twin& twin) {
  const PlainProblem& plain = twin.plain;
  SearchProblem p;
  const auto optional = [](const std::optional<Real>& v) {
    return v ? std::optional(static_cast<double>(*v)) : std::nullopt;
  };
  p.ratio = twin.ratio;
  p.center_distance = twin.center_distance;
  p.modules = twin.modules;
  p.pinion_teeth = twin.pinion_teeth;
  p.helix = {Angle::radians(static_cast<double>(plain.beta))};
  p.normal_pressure_angle = Angle::radians(static_cast<double>(plain.alpha_n));
  SearchRacks& racks = p.racks[0];
  for (StraightRack& rack : racks.rack) {
    rack.addendum = static_cast<double>(plain.ha);
    rack.dedendum = static_cast<double>(plain.hf);
  }
  racks.undercut_depth.fill(static_cast<double>(plain.undercut_depth));
  racks.flank_depth = racks.undercut_depth;  // the twin supports only one depth
  p.coprime = twin.coprime;
  p.mounting = plain.tight ? Mounting::tight : Mounting::extended;
  SearchLimits& limits = p.limits;
  limits.min_shift = optional(plain.floor);
  limits.max_shift = optional(plain.ceil);
  limits.undercut_margin = static_cast<double>(plain.undercut_margin);
  limits.tip_thickness = static_cast<double>(plain.tip_thickness_min);
  limits.contact_ratio = static_cast<double>(plain.contact_ratio_min);
  limits.sliding = optional(plain.sliding_max);
  limits.tip_clearance = optional(plain.clearance_min);
  limits.avoid_interference = plain.avoid_interference;
  return p;
}

/// Passes the doubles of the engine to the plain search, so that both problems are identical.
inline void share_doubles(Twin& twin) {
  twin.plain.clip = PlainClip::usable_flanks;
  PlainProblem& p = twin.plain;
  for (Real* v : {&p.alpha_n, &p.beta, &p.ha, &p.hf, &p.undercut_depth, &p.undercut_margin,
                  &p.tip_thickness_min, &p.contact_ratio_min})
    *v = static_cast<double>(*v);
  for (std::optional<Real>* v : {&p.floor, &p.ceil, &p.sliding_max, &p.clearance_min})
    if (*v) *v = static_cast<double>(**v);
}

class TwinRandom {
 public:
  explicit TwinRandom(unsigned seed) : bits_(seed) {}
  double uniform(double lo, double hi) { return lo + (hi - lo) * (bits_() / 4294967296.0); }
  int whole(int lo, int hi) { return static_cast<int>(uniform(lo, hi + 1)); }
  bool chance(double p) { return uniform(0, 1) < p; }

 private:
  std::mt19937 bits_;
};

enum class TwinKind { extended, helical, tight, ring, tight_ring };
inline constexpr std::array kTwinKinds{TwinKind::extended, TwinKind::helical, TwinKind::tight,
                                       TwinKind::ring, TwinKind::tight_ring};

/// A search of a few dozen trials around one pair, with each optional limit in some of them.
inline Twin random_twin(TwinRandom& random, TwinKind kind) {
  Twin twin;
  PlainProblem& p = twin.plain;
  const bool ring = kind == TwinKind::ring || kind == TwinKind::tight_ring;
  p.tight = kind == TwinKind::tight || kind == TwinKind::tight_ring;
  p.alpha_n = random.uniform(17, 25) * std::numbers::pi / 180.0;
  if (kind == TwinKind::helical || random.chance(0.3)) p.beta = random.uniform(0.05, 0.55);
  p.avoid_interference = random.chance(0.4);
  if (ring || p.avoid_interference || random.chance(0.5)) p.floor = random.uniform(-0.6, 0.0);
  if (ring || random.chance(0.6)) p.ceil = random.uniform(0.3, 1.0);
  if (random.chance(0.3)) p.undercut_margin = random.uniform(-0.6, 0.2);
  p.undercut_depth = random.chance(0.7) ? 1.0 : random.uniform(0.9, 1.25);
  p.tip_thickness_min = random.uniform(0.0, 0.45);
  p.contact_ratio_min = random.uniform(1.0, 1.8);
  if (random.chance(0.4)) p.sliding_max = random.uniform(0.5, 4.0);
  if (random.chance(0.4)) p.clearance_min = random.uniform(0.15, 0.249);
  const int z1 = random.whole(8, 45);
  const int z2 = ring ? -(z1 + random.whole(9, 80)) : z1 + random.whole(0, 60);
  const double m = 2.0;
  twin.modules = {m};
  twin.pinion_teeth = {z1, z1 + 2};
  const double u = static_cast<double>(z2) / z1;
  twin.ratio = {u - 0.05, u + 0.05};
  if (ring) twin.ratio[1] = std::min(twin.ratio[1], -1.0 - 9.0 / (z1 + 2));
  if (!ring) twin.ratio[0] = std::max(twin.ratio[0], 1.0);
  const double a = m * std::abs(z1 + z2) / (2.0 * static_cast<double>(std::cos(p.beta)));
  const double least = a + random.uniform(-1.5, 2.0) - (random.chance(0.1) ? 0.05 * a : 0.0);
  twin.center_distance = {least, random.chance(0.2) ? least : least + random.uniform(0.0, 1.0)};
  twin.coprime = random.chance(0.2);
  return twin;
}

}  // namespace gearwright::oracle
