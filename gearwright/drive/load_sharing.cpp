#include "gearwright/drive/load_sharing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gearwright/math/decompositions.hpp"

namespace gearwright::detail {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// An additional stiffness, relative to the greatest one. It holds bodies that no spring touches.
/// The stiffness affects the steps, but not the solution.
constexpr double kHold = 1e-12;
/// A step is halved while it changes the sign of the energy's slope and the magnitude of the new
/// slope exceeds this fraction of the old magnitude.
constexpr double kPast = 0.1;
constexpr int kHalvings = 60;
constexpr double kRounding = std::numeric_limits<double>::epsilon();

struct State {
  VectorXd gradient;      // Σ w F c − Q
  double scale = 0.0;     // greatest component of |Q| + Σ |w F c|
  double rounding = 0.0;  // error of the forces due to the rounding of the approaches
};

double approach_of(const SharingProblem::Spring& s, const VectorXd& x) {
  return s.row.dot(x) + s.offset;
}

State state_at(const SharingProblem& problem, const VectorXd& x) {
  State state{-problem.load};
  VectorXd sum = problem.load.cwiseAbs();
  for (const auto& s : problem.springs) {
    const LoadSpring::Value value = s.spring->at(approach_of(s, x));
    const double force = s.weight * value.force;
    state.gradient += force * s.row;
    sum += force * s.row.cwiseAbs();
    state.rounding += kRounding * s.weight * value.slope *
                      (s.row.cwiseAbs().dot(x.cwiseAbs()) + std::abs(s.offset));
  }
  state.scale = sum.maxCoeff();
  return state;
}

VectorXd newton_step(const SharingProblem& problem, const VectorXd& x, const VectorXd& gradient) {
  MatrixXd h = MatrixXd::Zero(x.size(), x.size());
  for (const auto& s : problem.springs)
    h += s.weight * s.spring->at(approach_of(s, x)).slope * s.row * s.row.transpose();
  double stiffest = h.diagonal().maxCoeff();
  if (!(stiffest > 0.0)) stiffest = 1.0;
  h.diagonal().array() += kHold * stiffest;
  return solve_linear(h, -gradient);
}

}  // namespace

SharingSolution share_load(const SharingProblem& problem, VectorXd start) {
  SharingSolution found;
  found.x = std::move(start);
  State state = state_at(problem, found.x);
  for (; found.iterations < kSharingSteps; ++found.iterations) {
    found.residual = state.scale > 0.0 ? state.gradient.cwiseAbs().maxCoeff() / state.scale : 0.0;
    if (found.residual * state.scale <= kSharingResidual * state.scale + state.rounding) {
      found.stop = SharingSolution::Stop::converged;
      break;
    }
    const VectorXd step = newton_step(problem, found.x, state.gradient);
    const double slope = state.gradient.dot(step);
    if (!(slope < 0.0)) {
      found.stop = SharingSolution::Stop::no_progress;
      break;
    }
    double length = 1.0;
    VectorXd to = found.x + step;
    State next = state_at(problem, to);
    for (int i = 0; i < kHalvings && next.gradient.dot(step) > -kPast * slope; ++i) {
      length /= 2;
      to = found.x + length * step;
      next = state_at(problem, to);
    }
    found.x = to;
    state = std::move(next);
  }
  for (const auto& s : problem.springs)
    found.forces.push_back(s.spring->at(approach_of(s, found.x)).force);
  return found;
}

SharingSolution share_load(const SharingProblem& problem) {
  // The iteration starts from the displacements at which the springs carry their nominal forces, in
  // the sense of least squares.
  const auto count = static_cast<Eigen::Index>(problem.springs.size());
  MatrixXd rows(count, problem.load.size());
  VectorXd approaches(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& s = problem.springs[static_cast<std::size_t>(i)];
    rows.row(i) = s.row.transpose();
    approaches[i] = s.spring->approach(s.nominal) - s.offset;
  }
  return share_load(problem, least_squares(rows, approaches));
}

}  // namespace gearwright::detail
