#include "gearwright/contact/continuous.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "gearwright/base/contract.hpp"
#include "gearwright/contact/sensitivity.hpp"

namespace gearwright {

namespace {

constexpr int kHalvings = 16;    // bisections to the end of a branch: 1.5e-5 of a step
constexpr double kSame = 1e-13;  // rad: two values of TE that differ by rounding
constexpr double kFlat = 1e-12;  // rad: no change closer than this to a handover or turn
constexpr int kMaxSteps = 30;    // limit of a search for a handover or a turn, which needs five

// The curve between positions, with the branches that have the greatest T at them.
class Branches {
 public:
  Branches(Transmission& transmission, const std::vector<PairTouch>& touches)
      : transmission_(transmission),
        touches_(touches),
        // In N the rotation of the housing is reversed if gear 2 drives.
        step_(transmission.pair().turned() * transmission.pair().pitch() /
              static_cast<double>(touches.size())) {}

  // Position i may exceed a pitch. The touch is then the same except for the number of the tooth
  // pair.
  const PairTouch& at(long i) const {
    const auto n = static_cast<long>(touches_.size());
    return touches_[static_cast<std::size_t>((i % n + n) % n)];
  }

  // The branch of `touch`, `steps` away; NaN where it no longer touches.
  double branch(const PairTouch& touch, double steps) const {
    const PairTouch there = moved(touch, steps);
    return there.found() ? there.te() : std::numeric_limits<double>::quiet_NaN();
  }

  // True if the branch that is greatest at i is also greatest at i + 1.
  bool same(long i) const {
    const PairTouch& a = at(i);
    const PairTouch& b = at(i + 1);
    return a.found() && b.found() && a.fields == b.fields &&
           std::abs(b.phi - a.phi - step_) < 0.5 * std::abs(step_);
  }

  // The part of a step over which the branch of `touch` continues in one direction: all of it, or
  // up to its last touch.
  double reach(const PairTouch& touch, double way) const {
    if (moved(touch, way).found()) return 1.0;
    PairTouch last = touch;
    double lo = 0.0;
    double hi = 1.0;
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = 0.5 * (lo + hi);
      const PairTouch next = transmission_.follow(last, touch.phi + way * middle * step_);
      (next.found() ? lo : hi) = middle;
      if (next.found()) last = next;
    }
    return lo;
  }

  // TE at the handover from the branch of i to that of i + 1; none if none can be found there.
  std::optional<double> handover(long i) const {
    const PairTouch& a = at(i);
    const PairTouch& b = at(i + 1);
    // Branch b begins at lo or continues to before i; branch a ends at hi or continues beyond i +
    // 1.
    double lo = 1.0 - reach(b, -1.0);
    double hi = reach(a, 1.0);
    if (lo >= hi) return std::nullopt;
    double at_lo = branch(a, lo) - branch(b, lo - 1.0);
    double at_hi = branch(a, hi) - branch(b, hi - 1.0);
    if (std::isnan(at_lo + at_hi)) return std::nullopt;
    // TE jumps if a branch begins or ends ahead of the other. The value is the limit on the low
    // side.
    if (at_lo <= kSame) return branch(a, lo);
    if (at_hi >= -kSame) return branch(b, hi - 1.0);
    int stays = 0;
    for (int k = 0; k < kMaxSteps; ++k) {
      const double t = lo + (hi - lo) * at_lo / (at_lo - at_hi);
      const double of_a = branch(a, t);
      const double of_b = branch(b, t - 1.0);
      const double ahead = of_a - of_b;
      if (std::isnan(ahead)) return std::nullopt;
      if (std::abs(ahead) < kFlat || k + 1 == kMaxSteps) {
        // A third branch that is greatest at a neighbour may be greatest here as well.
        double te = std::max(of_a, of_b);
        if (!same(i - 1)) te = not_below(te, branch(at(i - 1), 1.0 + t));
        if (!same(i + 1)) te = not_below(te, branch(at(i + 2), t - 2.0));
        return te;
      }
      narrow(ahead > 0.0, t, ahead, lo, at_lo, hi, at_hi, stays);
    }
    return std::nullopt;
  }

  // The value at which the branch of i has an extreme, within a step uphill (`up`) or downhill of
  // i. Its slope is exact and continuous, but may change sharply where the contact reaches an edge.
  std::optional<double> turning_point(long i, bool up) const {
    const PairTouch& here = at(i);
    double lo = 0.0;
    double at_lo = slope(here);
    if (!(std::abs(at_lo) > 0.0)) return std::nullopt;
    const double way = (at_lo > 0.0) == up ? 1.0 : -1.0;
    double hi = way * reach(here, way);
    const PairTouch end = moved(here, hi);
    double at_hi = slope(end);
    if ((at_lo > 0.0) == (at_hi > 0.0)) {
      // The branch may be greatest where it begins or ends.
      return up && std::abs(hi) < 1.0 ? std::optional(end.te()) : std::nullopt;
    }
    double best = here.te();
    int stays = 0;
    for (int k = 0; k < kMaxSteps; ++k) {
      const double t = lo + (hi - lo) * at_lo / (at_lo - at_hi);
      const PairTouch turn = moved(here, t);
      if (!turn.found()) return std::nullopt;
      best = up ? std::max(best, turn.te()) : std::min(best, turn.te());
      const double at_turn = slope(turn);
      const bool low = (at_turn > 0.0) == (at_lo > 0.0);
      // The remaining change up to the other end of the bracket is below this.
      if (std::abs(at_turn * ((low ? hi : lo) - t)) < kFlat) break;
      narrow(low, t, at_turn, lo, at_lo, hi, at_hi, stays);
    }
    return best;
  }

 private:
  PairTouch moved(const PairTouch& touch, double steps) const {
    if (!touch.found() || steps == 0.0) return touch;
    return transmission_.follow(touch, touch.phi + steps * step_);
  }
  // Slope of T, rad per step.
  double slope(const PairTouch& touch) const {
    return step_ * rotation_slope(transmission_, touch);
  }
  static double not_below(double te, double other) { return other > te ? other : te; }
  // Narrows the bracket of a root after the evaluation at t. An end that stays twice gets half its
  // value (Illinois).
  static void narrow(bool low, double t, double value, double& lo, double& at_lo, double& hi,
                     double& at_hi, int& stays) {
    (low ? lo : hi) = t;
    (low ? at_lo : at_hi) = value;
    const int stayed = low ? 1 : -1;
    if (stays == stayed) (low ? at_hi : at_lo) *= 0.5;
    stays = stayed;
  }

  Transmission& transmission_;
  const std::vector<PairTouch>& touches_;
  double step_;
};

}  // namespace

CurveExtremes continuous_extremes(Transmission& transmission,
                                  const std::vector<PairTouch>& touches) {
  const Branches curve(transmission, touches);
  CurveExtremes e{std::numeric_limits<double>::infinity(),
                  -std::numeric_limits<double>::infinity()};
  for (const PairTouch& t : touches) {
    if (!t.found()) continue;
    e.least = std::min(e.least, t.te());
    e.greatest = std::max(e.greatest, t.te());
  }
  GW_EXPECTS(e.least <= e.greatest);
  if (e.greatest - e.least < kSame) return e;
  const auto n = static_cast<long>(touches.size());
  for (long i = 0; i < n; ++i) {
    const PairTouch& before = curve.at(i - 1);
    const PairTouch& here = curve.at(i);
    const PairTouch& after = curve.at(i + 1);
    if (!here.found() || !after.found()) continue;
    if (!curve.same(i)) {
      if (const auto te = curve.handover(i)) e.least = std::min(e.least, *te);
    }
    if (!before.found()) continue;
    // The curve may have an extreme where a line through two positions exceeds the extreme so far.
    const double reach =
        std::max(std::abs(here.te() - before.te()), std::abs(after.te() - here.te()));
    // A branch never exceeds TE, but beyond a handover it may lie below TE.
    if (here.te() + reach > e.greatest) {
      if (const auto te = curve.turning_point(i, true)) e.greatest = std::max(e.greatest, *te);
    }
    if (here.te() - reach < e.least && curve.same(i - 1) && curve.same(i)) {
      if (const auto te = curve.turning_point(i, false)) e.least = std::min(e.least, *te);
    }
  }
  return e;
}

}  // namespace gearwright
