// Least values of a function of several numbers within a box, without derivatives.
//
// By NLopt: DIRECT-L (Gablonsky and Kelley, 2001) divides the box, Subplex (Rowan, 1990) runs
// downhill from a start. A build without NLopt has neither: can_minimise() says so, and whoever
// needs them refuses the work beforehand.
#pragma once

#include <functional>
#include <vector>

namespace gearwright {

enum class Minimiser {
  whole_box,  ///< DIRECT-L: looks everywhere, from the middle on
  downhill    ///< Subplex: from the start into a valley near it
};

/// A search ends at so many evaluations, or when f changes by less than either gain.
struct MinimiserTask {
  std::vector<double> lo{}, hi{};  ///< the box
  std::vector<double> step{};      ///< > 0: first steps
  int evaluations = 1;
  double relative_gain = 0.0;
  double gain = 0.0;
  std::function<double(const std::vector<double>&)> f{};  ///< finite everywhere in the box
};

/// Whether this build has the minimisers.
bool can_minimise();

/// The best that was found from `start` on.
///
/// Domain    as many of lo, hi and step as of start; lo ≤ start ≤ hi; can_minimise() (contract)
std::vector<double> minimise(Minimiser how, const MinimiserTask& task, std::vector<double> start);

}  // namespace gearwright
