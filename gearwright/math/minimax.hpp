// Minimises the greatest of many functions of several variables within a box, with derivatives.
//
//   f(x) = max_k f_k(x)      plane k at x0: f_k(x0) + f_k'(x0)·(x − x0)
//
// The least value of the greatest plane is a linear program. It is solved by the simplex method on
// the dual program, in which the next column is the plane that is greatest at the last vertex. The
// planes are therefore never listed. A descent solves such a program in each step, within a trust
// region.
//
// Sources   Dantzig, Linear Programming and Extensions (1963); Madsen, An algorithm for minimax
//           solution of overdetermined systems of non-linear equations (1975), for the descent
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "gearwright/base/numbers.hpp"

namespace gearwright {

/// The value of a linear function at a point, and its slope.
struct Tangent {
  double value = 0.0;
  Eigen::VectorXd slope{};
};

/// Returns, of a fixed set of planes, one whose value is greatest at the point.
using GreatestTangent = std::function<Tangent(const Eigen::VectorXd&)>;

/// The point in the box lo ≤ x ≤ hi at which the greatest plane is least.
///
/// Domain    the set of planes is finite; lo ≤ hi, at least one variable (contract)
/// Accuracy  the greatest plane exceeds its least value by at most 1e-10 of its greatest value at
///           the corners that the search visits, unless the limit of 100 steps per variable ends
///           the search
Eigen::VectorXd lowest_of_tangents(const GreatestTangent& greatest, const Eigen::VectorXd& lo,
                                   const Eigen::VectorXd& hi);

/// The planes of f at a point. `value` is f at the point, infinity if f does not exist there.
/// `greatest` returns the plane that is greatest after a step from the point.
struct Tangents {
  double value = kInfinity;
  GreatestTangent greatest{};
};

struct MinimaxTask {
  std::vector<double> lo{}, hi{};  ///< ends of the box
  double radius = 0.25;            ///< of the first trust region, as a fraction of the box
  double last_radius = 1e-4;       ///< the descent ends below this radius
  double relative_gain = 0.0;      ///< the descent ends if a step promises less, relative to f
  int most = 60;                   ///< greatest number of evaluations
  std::function<Tangents(const std::vector<double>&)> f{};
};

/// The lowest point that a descent from `start` finds.
///
/// Domain    lo and hi are as long as start; lo ≤ start ≤ hi (contract)
/// Laws      f at the result is not greater than f at the start
std::vector<double> minimax_descent(const MinimaxTask& task, std::vector<double> start);

}  // namespace gearwright
