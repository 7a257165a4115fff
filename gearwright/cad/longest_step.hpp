// Marching along an interval by steps that are each as long as a condition allows.
//
// Where the condition fails for every longer step once it has failed (an error that grows with the
// length), steps as long as possible are the fewest that cover the interval.
#pragma once

#include <algorithm>

namespace gearwright {

struct StepLimits {
  double shortest;  ///< of the interval's unit: a step this short is taken, fit or not
  double known;     ///< the end is known well enough when bracketed within this part of the step
};

/// The greatest x in (from, to] with fits(x), by a bracket grown from `guess`, a step length.
///
/// Accuracy  within limits.known of the step, on the side that fits; from + shortest if nothing
///           fits
/// Domain    from < to, guess > 0
template <class Fits>
double longest_step(double from, double to, double guess, StepLimits limits, const Fits& fits) {
  if (to - from <= limits.shortest || fits(to)) return to;
  double good = from;
  double bad = to;
  double next = std::min(from + guess, 0.5 * (from + to));
  while (true) {
    if (fits(next)) {
      good = next;
      next = std::min(from + 1.5 * (good - from), 0.5 * (good + bad));
    } else {
      bad = next;
      if (good == from && bad - from <= limits.shortest) return bad;
      next = 0.5 * (good + bad);
    }
    if (good > from && bad - good <= limits.known * (good - from)) return good;
  }
}

}  // namespace gearwright
