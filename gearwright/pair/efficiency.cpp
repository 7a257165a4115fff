#include "gearwright/pair/efficiency.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/vector.hpp"

namespace gearwright {

namespace {

// A vector in the common tangent plane of the flanks, as a linear function `at` + s · `slope` of
// the position s on the path of contact.
struct Linear {
  Vec2 at, slope;
  Linear from(double s) const { return {at + s * slope, slope}; }
};

// Returns ∫ (u·w)/|u| ds from lo to hi. Here |u|² = A (s² + k²), and s is measured from the
// point at which |u| is least.
double projected(const Linear& u, const Linear& w, double A, double k, double lo, double hi) {
  const double p2 = u.slope.dot(w.slope);
  const double p1 = u.at.dot(w.slope) + u.slope.dot(w.at);
  const double p0 = u.at.dot(w.at);
  const auto primitive = [&](double s) {
    const double root = std::hypot(s, k);
    // If k = 0, u is 0 at the origin, and therefore p0 is also 0.
    const double area = k > 0.0 ? (p0 - p2 * k * k / 2) * std::asinh(s / k) : 0.0;
    return area + p1 * root + p2 * s * root / 2;
  };
  return (primitive(hi) - primitive(lo)) / std::sqrt(A);
}

}  // namespace

SlidingShares sliding_shares(const MeshInput<double>& in, const Mesh<double>& mesh) {
  const double begin = mesh.rho1_true_begin, end = mesh.rho1_true_end;
  return sliding_shares({begin, end, mesh.step, flank_speeds(in, mesh, begin),
                         flank_speeds(in, mesh, end),
                         in.gears[0].radius * std::cos(in.gears[0].helix_angle)});
}

SlidingShares sliding_shares(const SlidingPath& path) {
  const double begin = path.begin, end = path.end;
  GW_EXPECTS(begin < end);
  std::array<Linear, 2> w;
  for (int i : {0, 1}) {
    const Vec2 a(path.at_begin.across[i], path.at_begin.along[i]);
    const Vec2 b(path.at_end.across[i], path.at_end.along[i]);
    w[i] = {a, (b - a) / (end - begin)};
  }
  Linear u{w[0].at - w[1].at, w[0].slope - w[1].slope};
  const double A = u.slope.squaredNorm();
  GW_ENSURES(A > 0.0);
  const double origin = -u.at.dot(u.slope) / A;  // distance from `begin` to the least |u|, mm
  const double k = std::abs(u.at.x() * u.slope.y() - u.at.y() * u.slope.x()) / A;
  u = u.from(origin);
  for (Linear& wi : w) wi = wi.from(origin);

  double weight = 0.0;
  std::array<double, 2> sum{};
  for (const ContactZone& zone : contact_zones(begin, end, path.step)) {
    if (zone.pairs == 0) continue;
    const double lo = zone.begin - begin - origin;
    const double hi = zone.end - begin - origin;
    weight += (hi - lo) / zone.pairs;
    for (int i : {0, 1}) sum[i] += projected(u, w[i], A, k, lo, hi) / zone.pairs;
  }
  weight *= path.normal_speed;
  return {sum[0] / weight, sum[1] / weight};
}

Efficiency efficiency(const SlidingShares& shares, double friction) {
  GW_EXPECTS(friction >= 0.0);
  const auto ratio = [](double out, double in) -> std::optional<double> {
    if (!(out > 0.0 && in > 0.0)) return std::nullopt;
    return out / in;
  };
  return {ratio(1 + friction * shares.second, 1 + friction * shares.first),
          ratio(1 - friction * shares.first, 1 - friction * shares.second)};
}

std::vector<ContactZone> contact_zones(double begin, double end, double step) {
  GW_EXPECTS(begin <= end && step > 0.0);
  // When a tooth pair is at end − k step, the k-th pair ahead of this pair leaves contact. When a
  // tooth pair is at begin + k step, the k-th pair behind this pair enters contact.
  const double ratio = (end - begin) / step;
  const int whole = static_cast<int>(std::floor(ratio));
  std::vector<double> cuts{begin, end};
  for (int k = 1; k <= whole; ++k) {
    cuts.push_back(begin + k * step);
    cuts.push_back(end - k * step);
  }
  std::sort(cuts.begin(), cuts.end());
  // Two cuts count as one if their distance, relative to the pitch, is less than this. Such cuts
  // occur if the contact ratio is an integer, because one tooth pair then enters contact at the
  // rotation at which another pair leaves contact.
  constexpr double kSameCut = 1e-9;
  const double nothing = kSameCut * step;
  std::vector<ContactZone> zones;
  double from = begin;
  for (const double cut : cuts) {
    if (cut - from < nothing) continue;
    const double middle = 0.5 * (from + cut);
    const int pairs = static_cast<int>(std::floor((end - middle) / step)) +
                      static_cast<int>(std::floor((middle - begin) / step)) + 1;
    zones.push_back({from, cut, pairs});
    from = cut;
  }
  if (ratio < 1.0) zones.push_back({end, begin + step, 0});
  return zones;
}

}  // namespace gearwright
