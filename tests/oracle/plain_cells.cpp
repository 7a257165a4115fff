#include "tests/oracle/plain_cells.hpp"

#include <algorithm>
#include <cmath>

namespace gearwright::oracle::plain {
namespace {

using Real = long double;

constexpr Real kFree = PlainMargins::kFree;
constexpr Real kSumRounding = 1e-15L;  // rounding error of a sum of shifts

}  // namespace

Real contact_margin(const Pair& pair, Real x1, Real x2) {
  PlainMargins m = look(pair, x1, x2).margins;
  m.s1min = m.s1max = m.s2min = m.s2max = kFree;
  return m.min();
}

Interval Box::x1_at(Real sum) const {
  const Real low = std::max(x1.low, sum - x2.high), high = std::min(x1.high, sum - x2.low);
  if (low <= high) return {low, high};
  return {(low + high) / 2, (low + high) / 2};  // rounding
}

Real upper_bound(const Pair& pair, const Box& box, const Cell& cell) {
  const PlainProblem& p = pair.problem;
  const Interval s = cell.s, x1 = cell.x1;
  Interval x2{std::max(box.x2.low, s.low - x1.high), std::min(box.x2.high, s.high - x1.low)};
  // The whole cell lies outside the polygon.
  if (x2.low > x2.high + kSumRounding) return -kFree;
  if (x2.low > x2.high) std::swap(x2.low, x2.high);

  const bool ring = pair.sigma < 0;
  const Interval n{pair.tangent_length(ring ? s.high : s.low),
                   pair.tangent_length(ring ? s.low : s.high)};
  const Interval rho_1e{pair.tip_curvature(1, x1.low), pair.tip_curvature(1, x1.high)};
  const Interval rho_2a{pair.tip_curvature(2, ring ? x2.high : x2.low),
                        pair.tip_curvature(2, ring ? x2.low : x2.high)};
  const Interval rho_1a = ring ? Interval{rho_2a.low - n.high, rho_2a.high - n.low}
                               : Interval{n.low - rho_2a.high, n.high - rho_2a.low};
  const Interval rho_2e = ring ? Interval{n.low + rho_1e.low, n.high + rho_1e.high}
                               : Interval{n.low - rho_1e.high, n.high - rho_1e.low};

  Real most = (rho_1e.high - rho_1a.low) / pair.base_pitch - p.contact_ratio_min;
  if (p.clip != PlainClip::none) {
    Real start = std::max(rho_1a.low, 0.0L);
    Real end = ring ? rho_1e.high : std::min(rho_1e.high, n.high);
    if (p.clip == PlainClip::usable_flanks) {
      start = std::max(start, pair.form_curvature(1, x1.low));
      if (!ring) end = std::min(end, n.high - pair.form_curvature(2, x2.low));
    }
    most = std::min(most, (end - start) / pair.base_pitch - p.contact_ratio_min);
  }
  if (p.sliding_max) {
    if (rho_1a.high <= 0 || rho_2e.high <= 0) return -kFree;
    const auto min_sliding = [](Interval above, Interval below) {  // |1 − above/below|
      const Real low = std::max(above.low, 0.0L) / below.high;
      const Real high = below.low > 0 ? above.high / below.low : kFree;
      return low > 1 ? low - 1 : (high < 1 ? 1 - high : 0.0L);
    };
    const auto times_u = [&](Interval rho) {
      return Interval{pair.u * rho.low, pair.u * rho.high};
    };
    for (const auto& [rho_1, rho_2] : {std::pair{rho_1a, rho_2a}, std::pair{rho_1e, rho_2e}}) {
      most = std::min(most, *p.sliding_max - min_sliding(rho_2, times_u(rho_1)));
      most = std::min(most, *p.sliding_max - min_sliding(times_u(rho_1), rho_2));
    }
  }
  if (p.clearance_min) {
    const auto clearance = [&](Real sum) {
      return p.hf - p.ha + pair.sigma * (pair.centre_distance(sum) - pair.standard_centre) - sum;
    };
    Real max_clearance = std::max(clearance(s.low), clearance(s.high));
    if (s.low < 0 && s.high > 0) max_clearance = std::max(max_clearance, clearance(0));
    most = std::min(most, max_clearance - *p.clearance_min);
  }
  if (p.avoid_interference) {
    most = std::min(most, rho_1a.high - pair.form_curvature(1, x1.low));
    if (!ring) most = std::min(most, rho_2e.high - pair.form_curvature(2, x2.low));
  }
  return most;
}

}  // namespace gearwright::oracle::plain
