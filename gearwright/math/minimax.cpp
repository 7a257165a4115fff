#include "gearwright/math/minimax.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gearwright/base/contract.hpp"
#include "gearwright/math/decompositions.hpp"

namespace gearwright {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kStepsPerVariable = 100;
// A plane that exceeds the value of the vertex by less than this fraction is not violated. The
// fraction refers to the greatest value of a plane so far.
constexpr double kNotHigher = 1e-10;
// A component of the change below this fraction of the greatest one is a rounding error.
constexpr double kNoChange = 1e-10;
// A vertex outside the box by less than this fraction of the box is within the box.
constexpr double kWithin = 1e-12;

}  // namespace

// The unknowns are t and x. Each row of `basis` is the left side of a condition that holds with
// equality at the vertex: t − s_k·x = c_k for a plane, x_i = lo_i or −x_i = −hi_i for an end of the
// box. The multipliers of these conditions are ≥ 0 in every step, so t is a lower bound of the
// result, which increases.
VectorXd lowest_of_tangents(const GreatestTangent& greatest, const VectorXd& lo,
                            const VectorXd& hi) {
  const Index n = lo.size();
  GW_EXPECTS(n > 0 && hi.size() == n && (lo.array() <= hi.array()).all());
  struct Condition {
    VectorXd left;
    double right;
  };
  const auto of_plane = [&](const Tangent& p, const VectorXd& x) {
    Condition c{VectorXd(n + 1), p.value - p.slope.dot(x)};
    c.left << 1.0, -p.slope;
    return c;
  };
  const auto of_end = [&](Index i, bool low) {
    Condition c{VectorXd::Zero(n + 1), low ? lo[i] : -hi[i]};
    c.left[i + 1] = low ? 1.0 : -1.0;
    return c;
  };
  const VectorXd middle = 0.5 * (lo + hi);
  const Tangent first = greatest(middle);
  MatrixXd basis(n + 1, n + 1);
  VectorXd right(n + 1);
  const auto put = [&](Index row, const Condition& c) {
    basis.row(row) = c.left;
    right[row] = c.right;
  };
  put(0, of_plane(first, middle));
  for (Index i = 0; i < n; ++i) put(i + 1, of_end(i, first.slope[i] >= 0.0));
  const VectorXd unit = VectorXd::Unit(n + 1, 0);
  VectorXd x = middle, best = middle;
  double least = first.value, scale = std::abs(first.value);
  for (Index step = 0; step < kStepsPerVariable * (n + 1); ++step) {
    const VectorXd vertex = solve_linear(basis, right);
    x = vertex.tail(n);
    const VectorXd beyond = (lo - x).cwiseMax(x - hi) - kWithin * (hi - lo);
    Index end = 0;
    Condition enters;
    if (beyond.maxCoeff(&end) > 0.0) {
      enters = of_end(end, x[end] < lo[end]);
    } else {
      x = x.cwiseMax(lo).cwiseMin(hi);
      const Tangent p = greatest(x);
      scale = std::max(scale, std::abs(p.value));
      if (p.value < least) {
        least = p.value;
        best = x;
      }
      if (!(p.value > vertex[0] + kNotHigher * scale)) break;
      enters = of_plane(p, x);
    }
    const VectorXd multiplier = solve_linear(basis.transpose(), unit);
    const VectorXd change = solve_linear(basis.transpose(), enters.left);
    Index leaves = -1;
    double ratio = kInfinity;
    for (Index j = 0; j <= n; ++j) {
      if (!(change[j] > kNoChange * change.cwiseAbs().maxCoeff())) continue;
      if (!(multiplier[j] / change[j] < ratio)) continue;
      ratio = multiplier[j] / change[j];
      leaves = j;
    }
    if (leaves < 0) break;
    put(leaves, enters);
  }
  return best;
}

std::vector<double> minimax_descent(const MinimaxTask& task, std::vector<double> start) {
  GW_EXPECTS(task.lo.size() == start.size() && task.hi.size() == start.size());
  const auto n = static_cast<Index>(start.size());
  const VectorXd lo = VectorXd::Map(task.lo.data(), n), hi = VectorXd::Map(task.hi.data(), n);
  GW_EXPECTS((lo.array() <= VectorXd::Map(start.data(), n).array()).all() &&
             (VectorXd::Map(start.data(), n).array() <= hi.array()).all());
  Tangents here = task.f(start);
  double radius = task.radius;
  for (int i = 1; i < task.most && std::isfinite(here.value) && radius >= task.last_radius; ++i) {
    const VectorXd at = VectorXd::Map(start.data(), n), reach = radius * (hi - lo);
    const VectorXd step =
        lowest_of_tangents(here.greatest, (lo - at).cwiseMax(-reach), (hi - at).cwiseMin(reach));
    const double promised = here.value - here.greatest(step).value;
    if (!(promised > task.relative_gain * std::abs(here.value))) break;
    const VectorXd to = (at + step).cwiseMax(lo).cwiseMin(hi);
    std::vector<double> next(to.begin(), to.end());
    Tangents there = task.f(next);
    const double gained = here.value - there.value;
    if (!(gained > 0.25 * promised)) radius *= 0.3;
    if (gained > 0.75 * promised) radius = std::min(2 * radius, 1.0);
    if (!(gained > 0.0)) continue;
    start = std::move(next);
    here = std::move(there);
  }
  return start;
}

}  // namespace gearwright
