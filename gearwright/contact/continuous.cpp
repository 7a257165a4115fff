#include "gearwright/contact/continuous.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/contact/contact.hpp"

namespace gearwright {

namespace {

constexpr int kHalvings = 16;    // bisections that find the end of a branch to 1.5e-5 of a step
constexpr double kSame = 1e-13;  // values of TE that differ by less than this, rad, are equal
constexpr double kFlat = 1e-12;  // accuracy of TE at a handover or an extreme, rad
constexpr int kMaxSteps = 30;    // limit of a search for a handover or an extreme; five are usual
constexpr int kDivisions = 6;    // limit of nested divisions of a step on wavy flanks
// Touches on different crests are farther apart than this fraction of the patch.
constexpr double kNear = 0.08;

// A bracket of a root, narrowed by the Illinois method: a secant, for which the value at an end that
// is kept twice in succession is halved. If an end is kept a third time, for example because the
// function has a kink or a jump at its root, the bracket is bisected.
struct Bracket {
  double lo, at_lo, hi, at_hi;
  int kept = 0;  // how often hi (positive) or lo (negative) has been kept in succession

  double next() const {
    if (std::abs(kept) > 2) return 0.5 * (lo + hi);
    return lo + (hi - lo) * at_lo / (at_lo - at_hi);
  }
  // Replaces one end by the evaluation at t.
  void narrow(double t, double value) {
    const bool low = (value > 0.0) == (at_lo > 0.0);
    (low ? lo : hi) = t;
    (low ? at_lo : at_hi) = value;
    kept = low ? std::max(kept, 0) + 1 : std::min(kept, 0) - 1;
    if (std::abs(kept) > 1) (low ? at_hi : at_lo) *= 0.5;
  }
};

// The curve of TE between the positions. A branch (continuous.hpp) leads at a rotation if its T is
// the greatest there. The curve is computed from the branches that lead at the positions.
class Branches {
 public:
  Branches(Transmission& transmission, const std::vector<PairTouch>& touches)
      : transmission_(transmission),
        touches_(touches),
        // If gear 2 drives, a rotation has opposite signs in the frame N and in the housing.
        step_(transmission.pair().turned() * transmission.pair().pitch() /
              static_cast<double>(touches.size())) {}

  // Returns the touch at position i. If i lies outside the pitch, the function returns the touch at
  // the equivalent position within the pitch. At position i, another tooth pair has the same touch.
  const PairTouch& at(long i) const {
    const auto n = static_cast<long>(touches_.size());
    return touches_[static_cast<std::size_t>((i % n + n) % n)];
  }

  // Returns the rotation of gear 1 at a touch from at(). If the position lies outside the pitch,
  // the result is the rotation at the equivalent position within the pitch.
  double rotation(const PairTouch& touch) const {
    return touch.phi + touch.pair * transmission_.pair().pitch();
  }

  // Returns the touch on the branch of `touch` at the rotation that is `steps` later. If this
  // branch has no contact there, found() of the result is false.
  PairTouch moved(const PairTouch& touch, double steps) const { return moved(touch, steps, touch); }
  // Works like the function above, but starts the search at `start`, a touch of the same branch
  // that is nearer to the result than `touch`.
  PairTouch moved(const PairTouch& touch, double steps, const PairTouch& start) const {
    if (!touch.found() || steps == 0.0) return touch;
    return transmission_.follow_pair(start.found() ? start : touch, touch.phi + steps * step_);
  }

  // True if one branch has the greatest T at both i and i + 1.
  bool same(long i) const { return same(at(i), at(i + 1), 1.0); }
  // True if two touches, `width` steps apart, are on the same branch. On wavy flanks, each crest of
  // a tooth pair is a branch.
  bool same(const PairTouch& a, const PairTouch& b, double width) const {
    const bool patches = a.fields == b.fields || transmission_.crosses_patches();
    const bool pair = a.found() && b.found() && patches &&
                      std::abs(b.phi - a.phi - width * step_) < 0.5 * std::abs(width * step_);
    if (!pair || !transmission_.wavy()) return pair;
    const FlankPatch& one = transmission_.field(a.fields).one();
    return std::abs(b.touch.s - a.touch.s) < kNear * (one.s_hi - one.s_lo) &&
           std::abs(b.touch.z - a.touch.z) < kNear * (one.z_hi - one.z_lo);
  }

  // Returns the part of the rotation `way` over which the branch of the touch continues, 0 to 1.
  // `way` is in steps.
  double reach(const PairTouch& touch, double way) const {
    if (moved(touch, way).found()) return 1.0;
    PairTouch last = touch;
    double lo = 0.0;
    double hi = 1.0;
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = 0.5 * (lo + hi);
      const PairTouch next = transmission_.follow_pair(last, touch.phi + way * middle * step_);
      (next.found() ? lo : hi) = middle;
      if (next.found()) last = next;
    }
    return lo;
  }

  struct Handover {
    double t;                       // steps from the touch a
    std::array<PairTouch, 2> both;  // at the handover; the second is not found if TE jumps
  };
  // Returns the handover between branch a and branch b, which lead at two rotations `width` steps
  // apart. Returns none if there is no handover.
  std::optional<Handover> handover(const PairTouch& a, const PairTouch& b, double width) const {
    // Branch b begins at lo. If lo = 0, branch b already exists at touch a. Branch a ends at hi. If
    // hi = width, branch a still exists at touch b.
    double lo = width * (1.0 - reach(b, -width));
    double hi = width * reach(a, width);
    if (lo >= hi) return std::nullopt;
    std::array<PairTouch, 2> both{a, b};
    const auto at_both = [&](double t) {
      return std::array{moved(a, t, both[0]), moved(b, t - width, both[1])};
    };
    const auto begin = at_both(lo);
    const auto end = at_both(hi);
    const auto ahead_at_lo = ahead_in(begin), ahead_at_hi = ahead_in(end);
    if (!ahead_at_lo || !ahead_at_hi) return std::nullopt;
    // TE jumps if a branch begins or ends with a T greater than that of the other branch. The least
    // TE is then the value on the low side of the jump.
    if (*ahead_at_lo <= kSame) return Handover{lo, {begin[0], PairTouch()}};
    if (*ahead_at_hi >= -kSame) return Handover{hi, {end[1], PairTouch()}};
    Bracket bracket{lo, *ahead_at_lo, hi, *ahead_at_hi};
    for (int k = 0; k < kMaxSteps; ++k) {
      const double t = bracket.next();
      both = at_both(t);
      const auto ahead = ahead_in(both);
      if (!ahead) return std::nullopt;
      if (std::abs(*ahead) < kFlat || k + 1 == kMaxSteps) return Handover{t, both};
      bracket.narrow(t, *ahead);
    }
    return std::nullopt;
  }

  // Returns the touches of both branches at the handover between i and i + 1. A third branch, which
  // leads at position i − 1 or i + 2, may have a greater T at the handover. In this case, the touch
  // of the third branch replaces both touches.
  std::optional<std::array<PairTouch, 2>> handover(long i) const {
    const auto found = handover(at(i), at(i + 1), 1.0);
    if (!found) return std::nullopt;
    const auto& [t, both] = *found;
    if (!both[1].found()) return both;
    std::array<PairTouch, 2> lead = both;
    double te = std::max(both[0].te(), both[1].te());
    for (const bool before : {true, false}) {
      if (before ? same(i - 1) : same(i + 1)) continue;
      const PairTouch third = before ? moved(at(i - 1), 1.0 + t) : moved(at(i + 2), t - 2.0);
      if (!third.found() || !(third.te() > te)) continue;
      lead = {third, PairTouch()};
      te = third.te();
    }
    return lead;
  }

  // Finds the points at which TE may be less than `least` between touches a and b, which are
  // `width` steps apart. Each point is passed to `take`. If a and b are on one branch, the point is
  // the minimum of this branch. Otherwise, the point is the handover between the two branches. On
  // wavy flanks, a third crest may lead at the point. The point then divides the interval, and both
  // parts are examined in the same way. If the branches do not meet because a crest ends, the
  // interval is halved.
  template <class Take>
  void valleys(const PairTouch& a, const PairTouch& b, double width, const double& least,
               int divisions, const Take& take) const {
    std::optional<Handover> found;
    if (same(a, b, width)) {
      if (!(slope(a) < 0.0 && slope(b) > 0.0)) return;
      if (const auto turn = turning_point(a, width, false))
        found = Handover{(turn->phi - a.phi) / step_, {*turn, *turn}};
      if (!found) return;
    } else {
      found = handover(a, b, width);
    }
    const bool meet = found && found->both[1].found();
    const double te = meet ? std::max(found->both[0].te(), found->both[1].te()) : least;
    if (meet && te >= least) return;
    const double t = meet ? found->t : 0.5 * width;
    const PairTouch lead = transmission_.at(rotation(a) + t * step_);
    if (!lead.found()) return;
    if (meet && lead.te() <= te + kFlat) return take(found->both[0], found->both[1]);
    take(lead, PairTouch());
    if (divisions == 0 || t <= 0.0 || t >= width) return;
    valleys(a, lead, t, least, divisions - 1, take);
    valleys(lead, b, width - t, least, divisions - 1, take);
  }

  // Returns a maximum (if `up` is true) or minimum of the branch that leads at i, within a step of
  // i. The slope of the branch is exact and continuous, but it has kinks where the contact reaches
  // an edge.
  std::optional<PairTouch> turning_point(long i, bool up) const {
    return turning_point(at(i), 1.0, up);
  }
  // A maximum or minimum of the branch of a touch, within `width` steps of the touch.
  std::optional<PairTouch> turning_point(const PairTouch& here, double width, bool up) const {
    const double at_lo = slope(here);
    if (!(std::abs(at_lo) > 0.0)) return std::nullopt;
    const double way = (at_lo > 0.0) == up ? width : -width;
    const double hi = way * reach(here, way);
    const PairTouch end = moved(here, hi);
    // reach() followed the branch to its end in small steps. A search that goes to this end in a
    // single step may lose the branch.
    if (!end.found()) return std::nullopt;
    const double at_hi = slope(end);
    if ((at_lo > 0.0) == (at_hi > 0.0)) {
      // If the slope has no root, the branch may be greatest at the point where it begins or ends.
      return up && std::abs(hi) < width ? std::optional(end) : std::nullopt;
    }
    PairTouch best = here;
    PairTouch turn = here;
    Bracket bracket{0.0, at_lo, hi, at_hi};
    for (int k = 0; k < kMaxSteps; ++k) {
      const double t = bracket.next();
      turn = moved(here, t, turn);
      if (!turn.found()) return std::nullopt;
      if (up ? turn.te() > best.te() : turn.te() < best.te()) best = turn;
      const double at_turn = slope(turn);
      bracket.narrow(t, at_turn);
      // Stop if the change of T up to the other end of the bracket is negligible.
      if (std::abs(at_turn * (bracket.hi - bracket.lo)) < kFlat) break;
    }
    return best;
  }

 private:
  // Returns T of the first touch minus T of the second, or none if a touch has no contact.
  static std::optional<double> ahead_in(const std::array<PairTouch, 2>& both) {
    if (!both[0].found() || !both[1].found()) return std::nullopt;
    return both[0].te() - both[1].te();
  }
  // Slope of T, rad per step.
  double slope(const PairTouch& touch) const {
    return step_ * rotation_slope(transmission_, touch);
  }

  Transmission& transmission_;
  const std::vector<PairTouch>& touches_;
  double step_;
};

}  // namespace

CurveExtremes continuous_extremes(Transmission& transmission,
                                  const std::vector<PairTouch>& touches) {
  const Branches curve(transmission, touches);
  CurveExtremes e{kInfinity, -kInfinity, {}, {}};
  const auto take_top = [&](const PairTouch& t) {
    if (t.te() > e.greatest) e.greatest = (e.top = t).te();
  };
  const auto take_bottom = [&](const PairTouch& a, const PairTouch& b) {
    const double te = b.found() ? std::max(a.te(), b.te()) : a.te();
    if (!(te < e.least)) return;
    e.least = te;
    e.bottom = {a, b};
  };
  for (const PairTouch& t : touches) {
    if (!t.found()) continue;
    take_bottom(t, {});
    take_top(t);
  }
  GW_EXPECTS(e.least <= e.greatest);
  if (e.greatest - e.least < kSame) return e;
  const auto n = static_cast<long>(touches.size());
  for (long i = 0; i < n; ++i) {
    const PairTouch& before = curve.at(i - 1);
    const PairTouch& here = curve.at(i);
    const PairTouch& after = curve.at(i + 1);
    if (!here.found() || !after.found()) continue;
    if (transmission.wavy()) {
      curve.valleys(here, after, 1.0, e.least, kDivisions, take_bottom);
    } else if (!curve.same(i)) {
      if (const auto both = curve.handover(i)) take_bottom((*both)[0], (*both)[1]);
    }
    if (!before.found()) continue;
    // Within a step of this position, the curve is assumed to change by at most `reach`. The
    // maximum of the branch is computed only if TE + `reach` exceeds e.greatest, and the minimum
    // only if TE − `reach` is below e.least.
    const double reach =
        std::max(std::abs(here.te() - before.te()), std::abs(after.te() - here.te()));
    // T of a branch never exceeds TE, so the maximum of a branch is never too great. The minimum of
    // a branch may be too small, because T is less than TE beyond a handover. The minimum is
    // therefore used only if the same branch leads here and at both neighbours.
    if (here.te() + reach > e.greatest)
      if (const auto turn = curve.turning_point(i, true)) take_top(*turn);
    if (!transmission.wavy() && here.te() - reach < e.least && curve.same(i - 1) && curve.same(i))
      if (const auto turn = curve.turning_point(i, false)) take_bottom(*turn, {});
  }
  return e;
}

std::optional<Angle> continuous_span(const ContactPair& pair, int positions) {
  Transmission transmission(pair);
  const auto touches =
      one_pitch(transmission, -0.5 * pair.pitch(), std::max(kLeastSpanPositions, positions));
  for (const PairTouch& t : touches)
    if (!t.found()) return std::nullopt;
  return Angle::radians(continuous_extremes(transmission, touches).span());
}

double span_slope(Transmission& transmission, const CurveExtremes& extremes,
                  const Influence& influence) {
  const double turned = transmission.pair().turned();
  const auto slope = [&](const PairTouch& t) {
    return turned * sensitivity(transmission, t, influence).te;
  };
  const auto& [a, b] = extremes.bottom;
  double bottom = slope(a);
  if (b.found()) {
    const double of_a = rotation_slope(transmission, a);
    const double of_b = rotation_slope(transmission, b);
    // If both branches have the same slope, they do not cross at one point. The slope of the first
    // branch is then used.
    if (of_a != of_b) bottom = (of_a * slope(b) - of_b * bottom) / (of_a - of_b);
  }
  return slope(extremes.top) - bottom;
}

}  // namespace gearwright
