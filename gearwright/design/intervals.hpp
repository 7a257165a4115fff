// Where a continuous function of one variable is not negative: closed intervals, ends solved.
//
// Signs are seen at nodes; between two nodes of different sign one root is solved by bracketing,
// and every node that stands higher than its neighbours without reaching zero is climbed by golden
// section first, so that a narrow interval between nodes is found too. Exact, to rounding, for
// functions whose superlevel sets are intervals (quasiconcave), as those of the s1–s2 graph are
// where docs/theory/09-design-search.md proves it; of others, humps narrower than a node's step
// beside a higher one may be missed.
#pragma once

#include <algorithm>
#include <vector>

#include "gearwright/math/root.hpp"

namespace gearwright {

struct Interval {
  double lo, hi;
};

inline constexpr int kIntervalNodes = 24;

namespace detail {

/// The higher place of f between a and b, by golden section; stops as soon as f > 0.
template <class F>
double climb(const F& f, double a, double b) {
  constexpr double kGolden = 0.6180339887498949;
  // Of a variable of size 1, as shifts and their sums are: golden section is at rounding long before.
  constexpr double kNarrow = 1e-13;
  double x = b - kGolden * (b - a);
  double y = a + kGolden * (b - a);
  double f_x = f(x);
  double f_y = f(y);
  for (int i = 0; i < 80 && b - a > kNarrow && f_x <= 0.0 && f_y <= 0.0; ++i) {
    if (f_x > f_y) {
      b = y;
      y = x;
      f_y = f_x;
      x = b - kGolden * (b - a);
      f_x = f(x);
    } else {
      a = x;
      x = y;
      f_x = f_y;
      y = a + kGolden * (b - a);
      f_y = f(y);
    }
  }
  return f_x > f_y ? x : y;
}

}  // namespace detail

/// The intervals of [a, b] where f ≥ 0, in growing order; a single point counts.
///
/// Domain    f continuous; a ≤ b, else none
template <class F>
std::vector<Interval> where_not_negative(const F& f, double a, double b,
                                         int nodes = kIntervalNodes) {
  std::vector<Interval> found;
  if (!(a <= b)) return found;
  if (a == b) {
    if (f(a) >= 0.0) found.push_back({a, a});
    return found;
  }
  struct Node {
    double x, value;
  };
  std::vector<Node> at;
  at.reserve(static_cast<std::size_t>(nodes) + 8);
  for (int i = 0; i <= nodes; ++i) {
    const double x = i == nodes ? b : a + (b - a) * i / nodes;
    at.push_back({x, f(x)});
  }
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (at[i].value >= 0.0) continue;
    const bool left = i == 0 || (at[i - 1].value < 0.0 && at[i - 1].value <= at[i].value);
    const bool right =
        i + 1 == at.size() || (at[i + 1].value < 0.0 && at[i + 1].value <= at[i].value);
    if (!left || !right) continue;
    const double top =
        detail::climb(f, at[i == 0 ? 0 : i - 1].x, at[i + 1 == at.size() ? i : i + 1].x);
    const double value = f(top);
    if (value < 0.0) continue;
    at.insert(at.begin() + static_cast<std::ptrdiff_t>(top > at[i].x ? i + 1 : i), {top, value});
    ++i;
  }
  // A node where f is exactly 0, as at a corner of the shift limits, is a root itself: what rises
  // between it and a negative neighbour is climbed to first.
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    const double l = at[i].value;
    const double r = at[i + 1].value;
    if (!((l == 0.0 && r < 0.0) || (l < 0.0 && r == 0.0))) continue;
    const double place = detail::climb(f, at[i].x, at[i + 1].x);
    const Node top{place, f(place)};
    if (!(top.value > 0.0)) continue;
    at.insert(at.begin() + static_cast<std::ptrdiff_t>(i + 1), top);
    ++i;
  }
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (at[i].value < 0.0) continue;
    Interval piece{at[i].x, at[i].x};
    // The root's own end may lie a rounding outside; the inner end of its bracket does not.
    if (i > 0) piece.lo = std::min(find_root(f, at[i - 1].x, at[i].x).x, at[i].x);
    while (i + 1 < at.size() && at[i + 1].value >= 0.0) ++i;
    piece.hi = at[i].x;
    if (i + 1 < at.size()) piece.hi = std::max(find_root(f, at[i].x, at[i + 1].x).x, at[i].x);
    found.push_back(piece);
  }
  return found;
}

}  // namespace gearwright
