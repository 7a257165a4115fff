// The least value of a function of one variable, without derivatives.
#pragma once

#include <algorithm>
#include <limits>

namespace gearwright {

/// The least value of f at steps + 1 equally spaced points of [0, 1]. `lo` and `hi` are the two
/// neighbours of the point at which f has this value. If the point is an end of [0, 1], it replaces
/// the missing neighbour.
struct LeastNode {
  double lo, hi;
  double least;
};

template <class F>
LeastNode least_node(const F& f, int steps) {
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i) {
    const double value = f(static_cast<double>(i) / steps);
    if (!(value < least)) continue;
    least = value;
    best = i;
  }
  return {std::max(0, best - 1) / static_cast<double>(steps),
          std::min(steps, best + 1) / static_cast<double>(steps), least};
}

/// The argument at which f is least, by a golden-section search.
///
/// Domain    f has one minimum in [from, to]
/// Accuracy  0.618^steps times the length of the interval, but limited by rounding errors of f
template <class F>
double golden_section(const F& f, double from, double to, int steps) {
  constexpr double kGolden = 0.6180339887498949;
  double left = to - kGolden * (to - from), right = from + kGolden * (to - from);
  double f_left = f(left), f_right = f(right);
  for (int k = 0; k < steps; ++k) {
    if (f_left < f_right) {
      to = right;
      right = left;
      f_right = f_left;
      left = to - kGolden * (to - from);
      f_left = f(left);
    } else {
      from = left;
      left = right;
      f_left = f_right;
      right = from + kGolden * (to - from);
      f_right = f(right);
    }
  }
  return f_left < f_right ? left : right;
}

/// The argument in [lo, hi] at which f is least.
///
/// Formula   the best of 17 equally spaced points, then a golden-section search between the two
///           neighbours of this point
/// Domain    f is finite and has one minimum between these neighbours. If f has several minima in
///           [lo, hi], the minimum next to the best point is found
/// Accuracy  1e-8 of the interval; within this distance of the minimum, f varies by rounding only
template <class F>
double place_of_least(const F& f, double lo, double hi) {
  constexpr int kParts = 16;
  constexpr int kSteps = 40;
  const auto place = [&](int k) { return lo + (hi - lo) * k / kParts; };
  int best = 0;
  double least = f(lo);
  for (int k = 1; k <= kParts; ++k) {
    const double value = f(place(k));
    if (!(value < least)) continue;
    least = value;
    best = k;
  }
  double from = place(std::max(0, best - 1));
  double to = place(std::min(kParts, best + 1));
  return golden_section(f, from, to, kSteps);
}

}  // namespace gearwright
