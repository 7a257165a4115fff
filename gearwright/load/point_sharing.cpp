#include "gearwright/load/point_sharing.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/math/decompositions.hpp"

namespace gearwright {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMostRounds = 100;
constexpr int kHalvings = 40;  // greatest number of halvings of a step
// The iteration ends at this residual, relative to the scale of the gaps and to the moment.
constexpr double kStillPoints = 1e-13;
// The unknowns are δ of every point and, as the last element, Θ.
class Sharing {
 public:
  explicit Sharing(const PointProblem& q) : q_(q), n_(q.gap.size()) {}

  VectorXd force(const VectorXd& x) const {
    VectorXd f(n_);
    for (Index i = 0; i < n_; ++i) f[i] = std::pow(std::max(x[i], 0.0) / q_.softness[i], 1.5);
    return f;
  }
  // dF/dδ
  VectorXd stiffness(const VectorXd& x) const {
    VectorXd d(n_);
    for (Index i = 0; i < n_; ++i)
      d[i] = 1.5 * std::sqrt(std::max(x[i], 0.0) / q_.softness[i]) / q_.softness[i];
    return d;
  }
  // Returns the errors of the gap equations, mm, followed by the relative error of the moment.
  VectorXd residual(const VectorXd& x) const {
    const VectorXd f = force(x);
    VectorXd r(n_ + 1);
    r.head(n_) = x.head(n_) + q_.yield * f + q_.gap - x[n_] * q_.arm;
    r[n_] = q_.arm.dot(f) / q_.moment - 1.0;
    return r;
  }
  MatrixXd slope(const VectorXd& x) const {
    const VectorXd d = stiffness(x);
    MatrixXd j = MatrixXd::Zero(n_ + 1, n_ + 1);
    j.topLeftCorner(n_, n_) = MatrixXd::Identity(n_, n_) + q_.yield * d.asDiagonal();
    j.topRightCorner(n_, 1) = -q_.arm;
    j.bottomLeftCorner(1, n_) = q_.arm.cwiseProduct(d).transpose() / q_.moment;
    return j;
  }
  // Returns the start of the iteration, at which the point that touches at the least rotation
  // carries the whole load.
  VectorXd start() const {
    Index first = 0;
    q_.gap.cwiseQuotient(q_.arm).minCoeff(&first);
    VectorXd f = VectorXd::Zero(n_);
    f[first] = q_.moment / q_.arm[first];
    VectorXd x(n_ + 1);
    const double delta = q_.softness[first] * std::pow(f[first], 2.0 / 3.0);
    x[n_] = (delta + q_.yield(first, first) * f[first] + q_.gap[first]) / q_.arm[first];
    x.head(n_) = x[n_] * q_.arm - q_.gap - q_.yield * f;
    return x;
  }

 private:
  const PointProblem& q_;
  Index n_;
};

}  // namespace

PointSharing share_points(const PointProblem& q) {
  const Index n = q.gap.size();
  GW_EXPECTS(n > 0 && q.moment > 0.0);
  GW_EXPECTS(q.arm.minCoeff() > 0.0 && q.softness.minCoeff() > 0.0);
  const Sharing all(q);
  PointSharing out;
  VectorXd x = all.start();
  const double length = x[n] * q.arm.maxCoeff();
  // The rounding error of a wide gap may exceed the approach, so the scale includes the gap.
  const VectorXd scale = (q.gap.cwiseAbs().array() + length).matrix();
  const auto size = [&](const VectorXd& r) {
    return std::max(r.head(n).cwiseAbs().cwiseQuotient(scale).maxCoeff(), std::abs(r[n]));
  };
  VectorXd r = all.residual(x);
  while (out.iterations < kMostRounds && size(r) > kStillPoints) {
    ++out.iterations;
    const VectorXd step = solve_linear(all.slope(x), r);
    double part = 1.0;
    VectorXd next = x - step;
    VectorXd left = all.residual(next);
    for (int i = 0; i < kHalvings && !(size(left) < size(r)); ++i) {
      part *= 0.5;
      next = x - part * step;
      left = all.residual(next);
    }
    if (!(size(left) < size(r))) break;
    x = next;
    r = left;
  }
  constexpr double kEnough = 1e-10;  // accepted residual if rounding prevents a further decrease
  out.found = size(r) <= kEnough;
  out.force = all.force(x);
  // The forces are scaled so that they give the exact moment. This removes the remaining residual,
  // which is a rounding error.
  out.force *= q.moment / q.arm.dot(out.force);
  out.approach = x[n];
  VectorXd unit = VectorXd::Zero(n + 1);
  unit[n] = 1.0 / q.moment;
  out.yield_per_moment = solve_linear(all.slope(x), unit)[n];
  return out;
}

}  // namespace gearwright
