#include "gearwright/generation/branch.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/math/root.hpp"

namespace gearwright::detail {

namespace {

// The transition of the outline from `last` to `next`. If one of the two branches is hidden, there
// is no transition. Otherwise, the transition lies at a height.
struct Joint {
  enum Kind { at_height, last_hidden, next_hidden } kind;
  double height = 0.0;
};

// Returns the height in [lo, hi] at which the half angles of `last` and `next` are equal. At lo,
// the half angle of `last` is smaller.
double crossing(const Branch& last, const Branch& next, double lo, double hi) {
  if (last.curve->radius_is_closed_form() && next.curve->radius_is_closed_form()) {
    const auto gap = [&](double h) { return last.theta_at(h) - next.theta_at(h); };
    const Root root = find_root(gap, lo, hi);
    GW_ENSURES(root.found());
    return root.x;
  }
  // The solver varies the parameter of the branch whose radius has no closed form. This avoids
  // nested root finding.
  const bool by_last = !last.curve->radius_is_closed_form();
  const Branch& free = by_last ? last : next;
  const Branch& other = by_last ? next : last;
  const auto gap_t = [&](double t) {
    const double difference = free.curve->polar_angle(t) - other.theta_at(free.height(t));
    return by_last ? difference : -difference;
  };
  const double t_a = free.t_at(lo);
  const double t_b = free.t_at(hi);
  return free.height(find_root(gap_t, std::min(t_a, t_b), std::max(t_a, t_b)).x);
}

// Returns the transition from `last` to `next`. The lower envelope of the half angles is
// continuous. If the height ranges of the two branches only touch, or if one branch ends before it
// crosses the other, the two branches have a common end within rounding. This happens if undercut
// begins at the end of a branch, or if a corner of the cutter's edge lies on the pitch line.
Joint joint(const Branch& last, const Branch& next) {
  if (!(next.height_lo < next.height_hi)) return {Joint::next_hidden};  // `next` has no extent
  const double lo = std::max(last.height_lo, next.height_lo);
  double hi = std::min(last.height_hi, next.height_hi);
  const auto gap = [&](double h) { return last.theta_at(h) - next.theta_at(h); };
  if (!(lo < hi)) {
    if (last.height_hi <= next.height_lo) return {Joint::at_height, last.height_hi};
    return {Joint::last_hidden};  // the caller checks whether the branch before `last` hides `next`
  }
  if (gap(lo) >= 0.0) {
    if (next.height_lo > last.height_lo) return {Joint::at_height, lo};
    return {Joint::last_hidden};
  }
  if (std::isinf(hi)) {
    // Both curves are involutes. At large heights, the involute with the smaller base circle has
    // the smaller half angle. The search ends at this multiple of `lo`, which no tooth reaches.
    constexpr double kFarOut = 1e6;
    hi = 2.0 * lo;
    while (gap(hi) < 0.0 && hi < kFarOut * lo) hi *= 2.0;
  }
  if (gap(hi) > 0.0) return {Joint::at_height, crossing(last, next, lo, hi)};
  if (last.height_hi < next.height_hi) return {Joint::at_height, hi};
  return {Joint::next_hidden};
}

// The largest distance, relative to the radius, between two computed ends that count as the same
// point. It is √ε, because θ varies like the square root of the radius at the start of a branch
// that is tangent to a circle about the axis (τ = π/2).
constexpr double kSamePoint = 1.5e-8;

// True if `next` begins at the end of `last`.
bool adjoin(const Branch& last, const Branch& next) {
  const Vec2 a = last.curve->point(last.t_hi);
  const Vec2 b = next.curve->point(next.t_lo);
  return (a - b).norm() <= kSamePoint * a.norm();
}

// Returns the branch of a chain at the height h. If two branches meet at h, the function returns
// the upper branch. If h is outside the chain, it returns null.
const Branch* at_height(const std::vector<Branch>& chain, double h) {
  if (chain.empty() || h < chain.front().height_lo) return nullptr;
  std::size_t i = 0;
  while (i + 1 < chain.size() && (chain[i + 1].height_lo <= h || chain[i].height_hi <= h)) ++i;
  return chain[i].height_hi > h ? &chain[i] : nullptr;
}

}  // namespace

std::vector<Branch> assemble(const std::vector<Branch>& branches, double tip_height) {
  std::vector<Branch> chain;
  const Branch* before = nullptr;  // the last branch added to the chain
  for (const Branch& branch : branches) {
    if (branch.height_lo >= tip_height && !chain.empty() && chain.back().height_hi >= tip_height)
      continue;
    Branch next = branch;
    if (chain.empty() || (next.smooth_start && before == &branch - 1)) {
      chain.push_back(next);
      before = &branch;
      continue;
    }
    std::size_t kept = chain.size();
    if (next.height_hi <= chain.back().height_lo) {
      // All of `next` lies below the last branch of the chain, so an earlier branch may hide it.
      const Branch* below = at_height(chain, next.height_hi);
      if (below && below->theta_at(next.height_hi) < next.theta_at(next.height_hi)) continue;
    }
    Joint j = joint(chain[kept - 1], next);
    while (j.kind == Joint::last_hidden && kept > 1) {
      --kept;
      j = joint(chain[kept - 1], next);
    }
    if (j.kind == Joint::next_hidden) continue;
    // If the crossing lies beyond the tip, `next` does not bound the tooth.
    if (j.kind == Joint::at_height && j.height >= tip_height) continue;
    if (j.kind == Joint::last_hidden) {
      chain.clear();
    } else {
      chain.resize(kept);
      chain.back().end_at(j.height);
      next.start_at(j.height);
      if (!adjoin(chain.back(), next)) return {};
    }
    chain.push_back(next);
    before = &branch;
  }
  return chain;
}

namespace {

// An end of a branch is not moved if its height would change by at most this fraction, because
// moving it can lose accuracy. Where the radius is stationary, the parameter of a moved end is
// accurate to only half of its digits.
constexpr double kSameHeight = 1e-12;

void append(std::vector<Branch>& chain, const std::vector<Branch>& from, double lo, double hi) {
  for (Branch b : from) {
    if (!(b.height_lo < hi && b.height_hi > lo)) continue;
    if (lo - b.height_lo > kSameHeight * std::abs(lo)) b.start_at(lo);
    if (b.height_hi - hi > kSameHeight * std::abs(hi)) b.end_at(hi);
    chain.push_back(std::move(b));
  }
}

constexpr double kRounding = 1e-13;  // rad; curves that coincide within this angle do not cross
// Rounding error of heights, relative to the height.
constexpr double kHeightRounding = 1e-14;

// Returns the least value of θ_a − θ_b over the heights that equal h within rounding. At the start
// of a branch that is tangent to a circle about the axis, θ varies like the square root of the
// height. A rounding error of h there causes a much greater error of θ.
double surely_above(const Branch& a, const Branch& b, double h) {
  const double near = kHeightRounding * std::abs(h);
  const double below = a.theta_at(std::max(a.height_lo, h - near));
  const double above = a.theta_at(std::min(a.height_hi, h + near));
  return std::min(below, above) - b.theta_at(h);
}

// Returns the first height in (from, to] at which the half angle of b is smaller than the half
// angle of a.
std::optional<double> passes_below(const Branch& a, const Branch& b, double from, double to) {
  constexpr int kCells = 48;
  const double lo = std::max(from, b.height_lo);
  const double hi = std::min(to, b.height_hi);
  if (!(lo < hi)) return std::nullopt;
  const auto gap = [&](double h) { return a.theta_at(h) - b.theta_at(h); };
  const auto below = [&](double h) { return gap(h) > kRounding && surely_above(a, b, h) > 0.0; };
  double before = lo;
  for (int i = 1; i <= kCells; ++i) {
    double h = i == kCells ? hi : lo + (hi - lo) * i / kCells;
    if (!below(h)) {
      before = h;
      continue;
    }
    if (gap(before) < 0.0) return find_root(gap, before, h).x;
    // The two curves coincide at `before` and possibly over some length, for example after a has
    // passed below b.
    for (double near = h; near - before > kSameHeight * std::abs(before);) {
      near = before + 0.5 * (near - before);
      if (gap(near) < -kRounding) return find_root(gap, near, h).x;
      if (below(near)) h = near;
    }
    return before;
  }
  return std::nullopt;
}

// Returns the lowest branch that continues from the end of the branch `ended` at the height h, or
// null if there is none.
const Branch* going_on(const std::vector<Branch>& branches, const Branch& ended, double h,
                       double same) {
  const double near = same * std::abs(h);
  const double theta = ended.theta_at(h);
  const Branch* lowest = nullptr;
  for (const Branch& b : branches) {
    if (b.height_lo > h + near || b.height_hi <= h + near) continue;
    if (std::abs(b.theta_at(h) - theta) > same) continue;
    // Distance, as a multiple of the tolerance, at which two branches from the same point have
    // separated.
    constexpr double kAhead = 1e3;
    const double ahead = std::min(b.height_hi, h + kAhead * near);
    if (!lowest || b.theta_at(ahead) < lowest->theta_at(ahead)) lowest = &b;
  }
  return lowest;
}

}  // namespace

std::vector<Branch> lower_envelope(const std::vector<Branch>& branches, double tip_height) {
  if (branches.empty()) return {};
  const Branch* own = &branches.front();
  double from = own->height_lo;
  std::vector<Branch> lower;
  const std::size_t most = 8 * branches.size();  // upper limit for the number of crossings
  // The number of iterations is limited, because two branches that alternately pass below each
  // other would cause an endless loop. If the limit is reached, the result is empty.
  for (std::size_t turns = 0; lower.size() < most && turns < 8 * most; ++turns) {
    const double end = std::min(own->height_hi, tip_height);
    double until = end;
    const Branch* next = nullptr;
    for (const Branch& b : branches) {
      if (&b == own) continue;
      const auto h = passes_below(*own, b, from, until);
      if (!h || (next && *h >= until)) continue;
      until = *h;
      next = &b;
    }
    if (until > from) append(lower, {*own}, from, until);
    if (!next && until >= tip_height - kAtTip * std::abs(tip_height)) return lower;
    // The small tolerance is tried first, because a branch may be shorter than the large tolerance.
    if (!next) next = going_on(branches, *own, until, kSameHeight);
    if (!next) next = going_on(branches, *own, until, kSamePoint);
    if (!next) return {};
    own = next;
    from = until;
  }
  return {};
}

bool is_continuous(const std::vector<Branch>& chain) {
  for (std::size_t i = 0; i + 1 < chain.size(); ++i)
    if (!adjoin(chain[i], chain[i + 1])) return false;
  return true;
}

}  // namespace gearwright::detail
