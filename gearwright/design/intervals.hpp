// Computes the closed intervals of [a, b] in which a continuous function of one variable is not
// negative. Each end of such an interval is a root of the function, or a or b.
//
// The function is evaluated at nodes. Between two nodes of different sign, bracketing finds one
// root. A narrow interval may also lie between nodes. If the function is negative at a node and
// smaller at both neighbours, golden section therefore searches for a maximum between them.
//
// A function is quasiconcave if its superlevel sets are intervals. For such a function, the result
// is exact except for rounding. docs/theory/09-design-search.md proves for which arguments the
// functions of the s1–s2 graph are quasiconcave. For other functions, a maximum may be missed if
// its interval is narrower than the distance between two nodes and lies next to a higher maximum.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "gearwright/math/root.hpp"

namespace gearwright {

struct Interval {
  double lo, hi;
};

inline constexpr int kIntervalNodes = 24;

/// Returns the number in the intervals that is nearest to 0, or none if there are no intervals.
inline std::optional<double> nearest_zero(const std::vector<Interval>& intervals) {
  std::optional<double> nearest;
  for (const Interval& i : intervals) {
    const double x = std::clamp(0.0, i.lo, i.hi);
    if (!nearest || std::abs(x) < std::abs(*nearest)) nearest = x;
  }
  return nearest;
}

/// Known properties of a function. They reduce the number of evaluations.
struct Hump {
  /// Upper limit of f″, except at creases, where f changes from one smooth function to another.
  double bend = std::numeric_limits<double>::infinity();
  double below = -1e-9;  ///< maxima below this value are ignored
};

namespace detail {

/// Returns the greatest possible value of a function between a and b. The second derivative of the
/// function is at most `bend`, and the function is known at a, x, y and b, where a < x < y < b. If
/// f(a) or f(b) is unknown, the argument is −∞. A concave function lies below the secant through
/// two points outside the interval between these points. A term with `bend` allows for functions
/// that are not concave.
inline double ceiling_of_hump(double a, double f_a, double x, double f_x, double y, double f_y,
                              double b, double f_b, double bend) {
  const auto rise = [](double lower, double upper) { return std::max(upper - lower, 0.0); };
  const double slope = (f_x - f_y) / (y - x);
  const double outside = std::max({slope * (x - a), -slope * (b - y), 0.0});
  const double from_left = rise(f_a, f_x) / (x - a) * (y - x);
  const double from_right = rise(f_b, f_y) / (b - y) * (y - x);
  const double inside = std::min(from_left, from_right);
  return std::max(f_x, f_y) + std::max(outside, inside) + bend * (b - a) * (b - a);
}

/// Searches for the maximum of f between a and b by golden section, and returns the best point. The
/// search ends if f > 0, or if f certainly does not exceed `hump.below`.
template <class F>
double climb(const F& f, double a, double b, const Hump& hump = {}) {
  constexpr double kGolden = 0.6180339887498949;
  // The search ends at this width of the interval. The width suits variables of the order of 1,
  // such as shifts and their sums.
  constexpr double kNarrow = 1e-13;
  constexpr double kUnknown = -std::numeric_limits<double>::infinity();
  double x = b - kGolden * (b - a);
  double y = a + kGolden * (b - a);
  double f_x = f(x);
  double f_y = f(y);
  double f_a = kUnknown;
  double f_b = kUnknown;
  for (int i = 0; i < 80 && b - a > kNarrow && f_x <= 0.0 && f_y <= 0.0; ++i) {
    if (ceiling_of_hump(a, f_a, x, f_x, y, f_y, b, f_b, hump.bend) < hump.below) break;
    if (f_x > f_y) {
      b = y;
      f_b = f_y;
      y = x;
      f_y = f_x;
      x = b - kGolden * (b - a);
      f_x = f(x);
    } else {
      a = x;
      f_a = f_x;
      x = y;
      f_x = f_y;
      y = a + kGolden * (b - a);
      f_y = f(y);
    }
  }
  return f_x > f_y ? x : y;
}

/// True if the node x is a root except for rounding, for example at a corner of the shift limits.
/// The chord to the next node then crosses zero within the rounding error of x, so bracketing
/// cannot improve the root.
inline bool is_root(double x, double f_x, double next, double f_next) {
  const double away = std::abs(next - x) * -f_x;
  return away <=
         4.0 * std::numeric_limits<double>::epsilon() * std::max(1.0, std::abs(x)) * (f_next - f_x);
}

}  // namespace detail

/// The intervals in which f ≥ 0, and the greatest value of f that was computed.
struct Superlevel {
  std::vector<Interval> pieces;
  double highest = -std::numeric_limits<double>::infinity();
};

template <class F>
Superlevel superlevel(const F& f, double a, double b, int nodes = kIntervalNodes,
                      const Hump& hump = {}) {
  Superlevel found;
  if (!(a <= b)) return found;
  const auto meet = [&](double value) { found.highest = std::max(found.highest, value); };
  if (a == b) {
    meet(f(a));
    if (found.highest >= 0.0) found.pieces.push_back({a, a});
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
    meet(at.back().value);
  }
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (at[i].value >= 0.0) continue;
    const bool left = i == 0 || (at[i - 1].value < 0.0 && at[i - 1].value <= at[i].value);
    const bool right =
        i + 1 == at.size() || (at[i + 1].value < 0.0 && at[i + 1].value <= at[i].value);
    if (!left || !right) continue;
    const double top =
        detail::climb(f, at[i == 0 ? 0 : i - 1].x, at[i + 1 == at.size() ? i : i + 1].x, hump);
    const double value = f(top);
    meet(value);
    if (value < 0.0) continue;
    at.insert(at.begin() + static_cast<std::ptrdiff_t>(top > at[i].x ? i + 1 : i), {top, value});
    ++i;
  }
  // A node with f = 0 is a root, for example at a corner of the shift limits. If f becomes positive
  // between this node and a neighbour with f < 0, the interval continues beyond the node.
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    const double l = at[i].value;
    const double r = at[i + 1].value;
    if (!((l == 0.0 && r < 0.0) || (l < 0.0 && r == 0.0))) continue;
    const double place = detail::climb(f, at[i].x, at[i + 1].x, hump);
    const Node top{place, f(place)};
    if (!(top.value > 0.0)) continue;
    at.insert(at.begin() + static_cast<std::ptrdiff_t>(i + 1), top);
    ++i;
  }
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (at[i].value < 0.0) continue;
    Interval piece{at[i].x, at[i].x};
    // Because of rounding, the computed root may lie on the wrong side of the inner node. The
    // interval always includes the inner node.
    const auto end = [&](const Node& outside, const Node& inside) {
      if (detail::is_root(outside.x, outside.value, inside.x, inside.value)) return outside.x;
      return find_root([&f](double x) { return f(x); }, std::min(outside.x, inside.x),
                       std::max(outside.x, inside.x))
          .x;
    };
    if (i > 0) piece.lo = std::min(end(at[i - 1], at[i]), at[i].x);
    while (i + 1 < at.size() && at[i + 1].value >= 0.0) ++i;
    piece.hi = at[i].x;
    if (i + 1 < at.size()) piece.hi = std::max(end(at[i + 1], at[i]), at[i].x);
    found.pieces.push_back(piece);
  }
  return found;
}

/// Returns the intervals of [a, b] in which f ≥ 0, in ascending order. They may be single points.
///
/// Domain    f continuous; if a > b, there are no intervals
template <class F>
std::vector<Interval> where_not_negative(const F& f, double a, double b, int nodes = kIntervalNodes,
                                         const Hump& hump = {}) {
  return superlevel(f, a, b, nodes, hump).pieces;
}

/// Returns the intervals in which f ≥ 0 or, if there are none, those in which f ≥ −touch.
///
/// Domain    touch much smaller than −hump.below
template <class F>
std::vector<Interval> where_not_negative_or_touching(const F& f, double a, double b, double touch,
                                                     const Hump& hump = {}) {
  Superlevel exactly = superlevel(f, a, b, kIntervalNodes, hump);
  // If f ≥ 0 gives no interval, a maximum that is zero except for rounding still counts as an
  // interval. The condition is therefore changed to f ≥ −touch. If there are intervals, this change
  // would only move their ends.
  if (!exactly.pieces.empty() || exactly.highest < hump.below) return std::move(exactly.pieces);
  return where_not_negative([&](double x) { return f(x) + touch; }, a, b, kIntervalNodes, hump);
}

}  // namespace gearwright
