#include "gearwright/generation/chain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gearwright/math/root.hpp"

namespace gearwright::detail {

namespace {

// How the outline goes on from `last` to `next`.
struct Joint {
  enum Kind { at_height, last_hidden, next_hidden } kind;
  double height = 0.0;
};

// The height in [lo, hi] at which last's half angle, smaller at lo, becomes the larger one.
double crossing(const Branch& last, const Branch& next, double lo, double hi) {
  if (last.curve->radius_is_closed_form() && next.curve->radius_is_closed_form()) {
    const auto gap = [&](double h) { return last.theta_at(h) - next.theta_at(h); };
    const Root root = find_root(gap, lo, hi);
    GW_ENSURES(root.found());
    return root.x;
  }
  // Solve in the parameter of the branch that has no closed radius: no root inside a root.
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

// The tooth is the lower envelope of the half angles. It has no jump; so where the radii of the two
// only touch, or where one ends without having crossed the other, they share that point up to
// rounding (undercut that begins just here, a corner of the edge on the pitch line).
Joint joint(const Branch& last, const Branch& next) {
  const double lo = std::max(last.height_lo, next.height_lo);
  double hi = std::min(last.height_hi, next.height_hi);
  const auto gap = [&](double h) { return last.theta_at(h) - next.theta_at(h); };
  if (!(lo < hi)) {
    if (last.height_hi <= next.height_lo) return {Joint::at_height, last.height_hi};
    return {Joint::last_hidden};  // unless what came before hides `next` too
  }
  if (gap(lo) >= 0.0) {
    if (next.height_lo > last.height_lo) return {Joint::at_height, lo};
    return {Joint::last_hidden};
  }
  if (std::isinf(hi)) {  // both straight: the one that rises less steeply wins far out
    hi = 2.0 * lo;
    while (gap(hi) < 0.0 && hi < 1e6 * lo) hi *= 2.0;
  }
  if (gap(hi) > 0.0) return {Joint::at_height, crossing(last, next, lo, hi)};
  if (last.height_hi < next.height_hi) return {Joint::at_height, hi};
  return {Joint::next_hidden};
}

// What two ends that ought to be one point may differ by, of their radius: the root of ε, since a
// branch that begins along a circle about the axis (τ = π/2) has θ like the root of its radius.
constexpr double kSamePoint = 1.5e-8;

// The branch of a chain at the height h, of two that meet there the upper one; nothing outside.
const Branch* at_height(const std::vector<Branch>& chain, double h) {
  if (chain.empty() || h < chain.front().height_lo) return nullptr;
  std::size_t i = 0;
  while (i + 1 < chain.size() && (chain[i + 1].height_lo <= h || chain[i].height_hi <= h)) ++i;
  return chain[i].height_hi > h ? &chain[i] : nullptr;
}

}  // namespace

std::vector<Branch> assemble(const std::vector<Branch>& branches, double tip_height) {
  std::vector<Branch> chain;
  const Branch* before = nullptr;  // the branch that ends the chain, whole
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
      // All of it lies below the last one: what that one goes on from may hide it.
      const Branch* below = at_height(chain, next.height_hi);
      if (below && below->theta_at(next.height_hi) < next.theta_at(next.height_hi)) continue;
    }
    Joint j = joint(chain[kept - 1], next);
    while (j.kind == Joint::last_hidden && kept > 1) {
      --kept;
      j = joint(chain[kept - 1], next);
    }
    if (j.kind == Joint::next_hidden) continue;
    if (j.kind == Joint::at_height && j.height >= tip_height) continue;  // takes over in the air
    if (j.kind == Joint::last_hidden) {
      chain.clear();
    } else {
      chain.resize(kept);
      chain.back().end_at(j.height);
      next.start_at(j.height);
      const Vec2 a = chain.back().curve->point(chain.back().t_hi);
      const Vec2 b = next.curve->point(next.t_lo);
      if (!((a - b).norm() <= kSamePoint * a.norm())) return {};
    }
    chain.push_back(next);
    before = &branch;
  }
  return chain;
}

namespace {

// The first height above `from` at which `other` comes to lie lower than `own`; where it does so at
// once, `from` itself. Branch by branch, on cells: two curves of a tooth cross twice at most.
constexpr double kRounding = 1e-13;  // rad: curves that coincide do not cross

std::optional<double> first_lower(const std::vector<Branch>& own, const std::vector<Branch>& other,
                                  double from, double to) {
  constexpr int kCells = 32;
  for (double lo = from; lo < to;) {
    const Branch* a = at_height(own, lo);
    if (!a) return std::nullopt;
    const Branch* b = at_height(other, lo);
    double hi = std::min(to, a->height_hi);
    if (b) hi = std::min(hi, b->height_hi);
    if (!b && lo < other.front().height_lo) hi = std::min(hi, other.front().height_lo);
    if (b) {
      const auto gap = [&](double h) { return a->theta_at(h) - b->theta_at(h); };
      double before = lo;
      for (int i = lo == from ? 1 : 0; i <= kCells; ++i) {
        const double h = i == kCells ? hi : lo + (hi - lo) * i / kCells;
        if (gap(h) > kRounding) return gap(before) < 0.0 ? find_root(gap, before, h).x : before;
        before = h;
      }
    }
    lo = hi;
  }
  return std::nullopt;
}

void append(std::vector<Branch>& chain, const std::vector<Branch>& from, double lo, double hi) {
  for (Branch b : from) {
    if (!(b.height_lo < hi && b.height_hi > lo)) continue;
    if (b.height_lo < lo) b.start_at(lo);
    if (b.height_hi > hi) b.end_at(hi);
    chain.push_back(std::move(b));
  }
}

// Lower at its first touch by more than rounding.
constexpr double kCaught = 1e-9;  // rad

}  // namespace

std::optional<std::vector<Branch>> lower_of(const std::vector<Branch>& chain, const Branch& leaving,
                                            double tip_height) {
  const double start = leaving.height_lo;
  const double theta = leaving.curve->polar_angle(leaving.t_lo);
  if (const Branch* at_start = at_height(chain, start)) {
    const bool goes_on = std::any_of(chain.begin(), chain.end(), [&](const Branch& b) {
      return std::abs(b.height_hi - start) <= kSamePoint * std::abs(start) &&
             std::abs(b.curve->polar_angle(b.t_hi) - theta) <= kSamePoint;
    });
    const bool caught = !goes_on && at_start->theta_at(start) - theta > kCaught;
    if (caught && start < tip_height) return std::nullopt;
  }
  const std::vector<Branch> one{leaving};
  std::vector<Branch> lower;
  const std::vector<Branch>* own = &chain;
  const std::vector<Branch>* other = &one;
  double from = chain.front().height_lo;
  const double to = chain.back().height_hi;
  const double last = std::min(to, tip_height);
  for (;;) {
    const double end = own == &one ? std::min(last, leaving.height_hi) : last;
    auto h = first_lower(*own, *other, from, end);
    // The next branch of the leaving cutter goes on from this one's end: continuity is looked at
    // when all are there.
    if (!h && end < last) h = end;
    if (!h) break;
    append(lower, *own, from, *h);
    std::swap(own, other);
    from = *h;
    if (own == &chain && from == leaving.height_hi) break;
  }
  append(lower, *own, from, to);
  return lower;
}

namespace {

// The first height in (from, to] at which b lies lower than a.
std::optional<double> passes_below(const Branch& a, const Branch& b, double from, double to) {
  constexpr int kCells = 48;
  const double lo = std::max(from, b.height_lo);
  const double hi = std::min(to, b.height_hi);
  if (!(lo < hi)) return std::nullopt;
  const auto gap = [&](double h) { return a.theta_at(h) - b.theta_at(h); };
  double before = lo;
  for (int i = 1; i <= kCells; ++i) {
    const double h = i == kCells ? hi : lo + (hi - lo) * i / kCells;
    if (gap(h) > kRounding) return gap(before) < 0.0 ? find_root(gap, before, h).x : before;
    before = h;
  }
  return std::nullopt;
}

// Where one branch ends the lowest of those that go on from there; null where none does.
const Branch* going_on(const std::vector<Branch>& branches, const Branch& ended, double h) {
  const double near = kSamePoint * std::abs(h);
  const double theta = ended.theta_at(h);
  const Branch* lowest = nullptr;
  for (const Branch& b : branches) {
    if (b.height_lo > h + near || b.height_hi <= h + near) continue;
    if (std::abs(b.theta_at(h) - theta) > kSamePoint) continue;
    const double ahead = std::min(b.height_hi, h + 1e3 * near);
    if (!lowest || b.theta_at(ahead) < lowest->theta_at(ahead)) lowest = &b;
  }
  return lowest;
}

}  // namespace

std::vector<Branch> lower_envelope(const std::vector<Branch>& branches, double tip_height) {
  if (branches.empty()) return {};
  const Branch* own = &branches.front();
  for (const Branch& b : branches) {
    if (b.height_lo < own->height_lo) own = &b;
  }
  double from = own->height_lo;
  std::vector<Branch> lower;
  const std::size_t most = 8 * branches.size();  // no two curves of a tooth cross more often
  while (lower.size() < most) {
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
    if (until >= tip_height) return lower;
    if (!next) next = going_on(branches, *own, until);
    if (!next) return {};
    own = next;
    from = until;
  }
  return {};
}

bool is_continuous(const std::vector<Branch>& chain) {
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    const Vec2 a = chain[i].curve->point(chain[i].t_hi);
    const Vec2 b = chain[i + 1].curve->point(chain[i + 1].t_lo);
    if (!((a - b).norm() <= kSamePoint * a.norm())) return false;
  }
  return true;
}

}  // namespace gearwright::detail
