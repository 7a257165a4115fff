// Extremes of the transmission error TE between the positions of a track. The gap field T of each
// tooth pair and its slope are known at every position. A cubic through two positions therefore
// predicts where T is extreme, or where one tooth pair hands over to the next. LaneSearch then
// computes the touches at all predicted points of a pitch together.
#include <array>
#include <cmath>

#include "gearwright/base/numbers.hpp"
#include "gearwright/contact/lane_track.hpp"

namespace gearwright::detail {

namespace {

// The search for an extreme ends when T differs from the extreme by less than this angle, rad.
constexpr double kFlatLane = 1e-12;
// The search for a handover ends at this distance from it, in steps. T is then extrapolated.
constexpr double kLastStep = 1e-6;
// At a handover between two tooth pairs, a third pair may have the greatest T unless its estimated
// T is below the T of the two pairs by at least this angle, rad.
constexpr double kClose = 1e-7;
constexpr int kMostRounds = 30;  // two are usual
constexpr int kNewton = 5;       // last round with Newton steps; later rounds use within()

// T between two positions, from its values and slopes. t is in steps from the first position.
struct Cubic {
  double v, s, a, b;
  double at(double t) const { return v + t * (s + t * (a + t * b)); }
  double slope(double t) const { return s + t * (2 * a + 3 * t * b); }
  double bend(double t) const { return 2 * a + 6 * t * b; }
};

// Returns the approximate root of f between 0 and 1. f must have opposite signs at 0 and 1.
template <class F>
double root_of(const F& f) {
  double lo = 0.0, hi = 1.0;
  double at_lo = f(0.0), at_hi = f(1.0);
  double t = 0.0;
  for (int k = 0; k < 8; ++k) {
    t = lo + (hi - lo) * at_lo / (at_lo - at_hi);
    const double here = f(t);
    const bool low = (here > 0.0) == (at_lo > 0.0);
    (low ? lo : hi) = t;
    (low ? at_lo : at_hi) = here;
    (low ? at_hi : at_lo) *= 0.5;
  }
  return t;
}

}  // namespace

// A predicted point of the curve between two positions. If `other` has a value, the point is the
// handover from the tooth pair at m to the tooth pair at `other`. Otherwise, the point is an
// extreme of the tooth pair at m.
struct LaneTrack::Candidate {
  int m;
  std::optional<int> other;
  bool up;
  double t;  // steps from m
  // The ends of the interval that contains the predicted point. At a handover, `value` is T of
  // the pair at m minus T of the pair at `other`. At an extreme, it is the slope of T.
  struct End {
    double t, value;
    std::array<PairTouch, 2> touch;
  } lo, hi;
  std::optional<End> before{};  // the previous touch of the search
  int stays = 0;
  bool done = false;

  // If the same end stays in two successive steps, its value is halved (Illinois method).
  void narrow(bool low, const End& here) {
    (low ? lo : hi) = here;
    const int stayed = low ? 1 : -1;
    if (stays == stayed) (low ? hi : lo).value *= 0.5;
    stays = stayed;
  }
  // Returns the next t, within the interval. For a handover, it is the root of the secant. Near an
  // extreme, T may consist of two nearly straight lines that meet at a kink. The next t of an
  // extreme is therefore the crossing of the tangents at both ends.
  double within(double step) const {
    const Touch &a = lo.touch[0].touch, &b = hi.touch[0].touch;
    const double width = hi.t - lo.t;
    if (other) return lo.t + width * lo.value / (lo.value - hi.value);
    const double part = ((b.te - a.te) / step - b.slope * width) / ((a.slope - b.slope) * width);
    return lo.t + width * (part > 0.0 && part < 1.0 ? part : 0.5);
  }
};

// Returns the position m of tooth pair 0 whose touch has the greatest T at position i of the pitch,
// 0 ≤ i ≤ n.
int LaneTrack::leader(int i) const {
  const int own = i % n_;
  return own - (best_[static_cast<std::size_t>(own)].pair - whole_) * n_;
}

std::optional<CurveExtremes> LaneTrack::extremes() const {
  CurveExtremes e{kInfinity, -kInfinity, {}, {}};
  for (const PairTouch& t : best_) {
    if (!t.found()) return std::nullopt;
    if (t.te() > e.greatest) e.greatest = (e.top = t).te();
    if (t.te() < e.least) e.least = (e.bottom = {t, PairTouch()})[0].te();
  }
  const auto cubic = [&](int m) {
    const PairTouch &a = *at(m), &b = *at(m + 1);
    const double v0 = a.te(), v1 = b.te(), s0 = a.touch.slope * step_, s1 = b.touch.slope * step_;
    return Cubic{v0, s0, 3 * (v1 - v0) - 2 * s0 - s1, 2 * (v0 - v1) + s0 + s1};
  };
  std::vector<Candidate> all;
  for (int i = 0; i < n_; ++i) {
    const int m = leader(i), other = leader(i + 1) - 1;
    for (const int k : {m, m + 1, other, other + 1})
      if (!at(k) || at(k)->touch.arm == 0.0) return std::nullopt;
    if (other == m) continue;
    const Cubic a = cubic(m), b = cubic(other);
    if (!(a.at(0) > b.at(0) && a.at(1) < b.at(1))) return std::nullopt;
    const double t = root_of([&](double x) { return a.at(x) - b.at(x); });
    for (int k = lo_ + ((m - lo_) % n_ + n_) % n_; k < lo_ + static_cast<int>(track_.size());
         k += n_)
      if (k != m && k != other && at(k) && at(k + 1) && cubic(k).at(t) > a.at(t) - kClose)
        return std::nullopt;
    all.push_back({m,
                   other,
                   false,
                   t,
                   {0.0, a.at(0) - b.at(0), {*at(m), *at(other)}},
                   {1.0, a.at(1) - b.at(1), {*at(m + 1), *at(other + 1)}}});
  }
  // TE is the greatest T of all branches. A maximum of a branch therefore never exceeds the maximum
  // of TE, and all maxima are examined. A minimum is examined only if the branch has the greatest T
  // at both positions. The tangents at both positions cross at a T that bounds the extreme. If this
  // T lies between the least and the greatest value found so far, the extreme is skipped.
  for (int m = lo_; m + 1 < lo_ + static_cast<int>(track_.size()); ++m) {
    if (!at(m) || !at(m + 1)) continue;
    const Cubic c = cubic(m);
    const double end = c.slope(1);
    if ((c.s > 0.0) == (end > 0.0)) continue;
    const bool up = c.s > 0.0;
    const double crossing = (c.at(1) - c.v - end) / (c.s - end);
    const double limit = c.v + c.s * crossing;
    const int i = ((m % n_) + n_) % n_;
    const bool leads = leader(i) == m && leader(i + 1) == m + 1;
    if (up ? limit <= e.greatest : !leads || limit >= e.least) continue;
    all.push_back({m,
                   std::nullopt,
                   up,
                   root_of([&](double x) { return c.slope(x); }),
                   {0.0, c.s, {*at(m), {}}},
                   {1.0, end, {*at(m + 1), {}}}});
  }
  for (int round = 0; round < kMostRounds; ++round) {
    std::vector<PairTouch> touches;
    for (const Candidate& c : all) {
      if (c.done) continue;
      const double part = (c.t - c.lo.t) / (c.hi.t - c.lo.t);
      for (const std::size_t k : {0, 1}) {
        if (k == 1 && !c.other) continue;
        const double phi = own(k == 0 ? c.m : *c.other) + c.t * step_;
        touches.push_back(start_between(c.lo.touch[k], c.hi.touch[k], part, phi));
      }
    }
    if (touches.empty()) return e;
    search_.solve(touches);
    cross_seams(touches);
    auto next = touches.begin();
    for (Candidate& c : all) {
      if (c.done) continue;
      Candidate::End here{c.t, 0.0, {}};
      for (const std::size_t k : {0, 1}) {
        if (k == 1 && !c.other) continue;
        here.touch[k] = *next++;
        if (!here.touch[k].found()) return std::nullopt;
      }
      const auto& [a, b] = here.touch;
      here.value = c.other ? a.te() - b.te() : a.touch.slope * step_;
      // The derivative of `value`. At an extreme, it is computed from the slopes at this touch and
      // the previous one if both have the same active bounds. Otherwise, it is computed from the
      // cubic. The cubic is less accurate, because the second derivative of T jumps where the
      // active bounds change.
      const bool alike = c.before && c.before->touch[0].fields == a.fields &&
                         c.before->touch[0].touch.active == a.touch.active;
      const double bend = c.other ? (a.touch.slope - b.touch.slope) * step_
                          : alike ? (here.value - c.before->value) / (c.t - c.before->t)
                                  : cubic(c.m).bend(c.t);
      const double rest = -here.value / bend;
      const bool low = (here.value > 0.0) == (c.lo.value > 0.0);
      const double far = std::abs(here.value * ((low ? c.hi : c.lo).t - c.t));
      const bool close = alike && std::abs(here.value * rest) < kFlatLane;
      c.done = c.other ? std::abs(rest) < kLastStep : far < kFlatLane || close;
      c.before = here;
      c.narrow(low, here);
      c.t += rest;
      if (!(c.t > c.lo.t && c.t < c.hi.t) || round > kNewton) c.t = c.within(step_);
      if (!c.done) continue;
      // T is extrapolated over the remaining distance to the handover or the extreme.
      const double way = c.other ? rest : close ? 0.5 * rest : 0.0;
      const double te = a.te() + a.touch.slope * step_ * way;
      if (c.up && te > e.greatest) {
        e.greatest = te;
        e.top = a;
      }
      if (!c.up && te < e.least) {
        e.least = te;
        e.bottom = {a, c.other ? b : PairTouch()};
      }
    }
  }
  return std::nullopt;
}

}  // namespace gearwright::detail
