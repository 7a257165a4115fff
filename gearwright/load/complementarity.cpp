#include "gearwright/load/complementarity.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "gearwright/base/contract.hpp"

namespace gearwright {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMost = 200;  // greatest number of steps
// After this many steps, only one place is added or removed per step, to avoid cycles.
constexpr int kOneByOne = 30;
constexpr double kStill = 1e-11;     // the steps end below this, relative to the greatest load
constexpr double kRounding = 1e-14;  // rounding error of a step, relative to the cancelling terms
constexpr double kRough = 1e-3;  // greatest accepted rounding error, relative to the greatest load
// A place is added if its overlap exceeds this fraction of the greatest displacement.
constexpr double kOverlap = 1e-12;
// Least load p for which ln(a0/a) is computed, relative to the mean load.
constexpr double kLeastLoad = 1e-9;

// The equations a p − arm Θ = right of the loaded places. The local term λ ln(a0/a) p is linearised
// about the last p. The constant part is λ p/2, so `a` is the derivative of w by p.
struct LoadedPlaces {
  MatrixXd a;
  VectorXd right, arm;
};

LoadedPlaces equations(const ContactProblem& q, const VectorXd& load, const std::vector<Index>& at,
                       double mean) {
  const auto m = static_cast<Index>(at.size());
  LoadedPlaces e{MatrixXd(m, m), VectorXd(m), VectorXd(m)};
  for (Index j = 0; j < m; ++j)
    for (Index i = 0; i < m; ++i) e.a(i, j) = (*q.yield)(at[i], at[j]);
  for (Index i = 0; i < m; ++i) {
    const Index k = at[i];
    const double p = std::max(load[k], kLeastLoad * mean);
    if (q.local > 0.0) {
      const double wide = hertz_half_width(p, q.radius[k], q.reduced_modulus);
      e.a(i, i) += q.local * (std::log(q.half_width / wide) - 0.5);
      e.right[i] = -q.gap[k] - 0.5 * q.local * p;
    } else {
      e.right[i] = -q.gap[k];
    }
    e.arm[i] = q.arm[k];
  }
  return e;
}

double mean_load(const ContactProblem& q) { return q.moment / (q.length * q.arm.sum()); }

}  // namespace

double hertz_half_width(double line_load, double radius, double reduced_modulus) {
  return std::sqrt(4 * line_load * radius / (std::numbers::pi * reduced_modulus));
}

ContactSolution solve_contact(const ContactProblem& q, const VectorXd& start) {
  const Index n = q.gap.size();
  GW_EXPECTS(n > 0 && q.moment > 0.0 && (start.size() == 0 || start.size() == n));
  const double mean = mean_load(q);
  ContactSolution x;
  const bool given = start.size() == n && start.maxCoeff() > 0.0;
  x.line_load = given ? start : VectorXd::Constant(n, mean);
  std::vector<char> active;
  for (const double p : x.line_load) active.push_back(p > 0.0 ? 1 : 0);
  for (int turn = 1; turn <= kMost; ++turn) {
    x.iterations = turn;
    std::vector<Index> at;
    for (Index i = 0; i < n; ++i)
      if (active[i]) at.push_back(i);
    const auto m = static_cast<Index>(at.size());
    const auto [a, right, arm] = equations(q, x.line_load, at, mean);
    if (!a.allFinite()) return x;  // LLT does not detect infinity or NaN
    const Eigen::LLT<MatrixXd> llt(a);
    if (llt.info() != Eigen::Success) {
      x.stop = ContactSolution::Stop::indefinite;
      return x;
    }
    // Solves a p − arm Θ = right with Δ armᵀ p = M2.
    const VectorXd free = llt.solve(right);
    const VectorXd turned = llt.solve(arm);
    const double stiffness = q.length * arm.dot(turned);
    x.yield_per_moment = 1.0 / stiffness;
    x.approach = (q.moment - q.length * arm.dot(free)) / stiffness;
    VectorXd p = free + x.approach * turned;
    VectorXd next = VectorXd::Zero(n);
    bool changed = false;
    const std::vector<char> before = active;
    const bool careful = turn > kOneByOne;
    for (Index i = 0; i < m && !(careful && changed); ++i) {
      if (p[i] >= 0.0) continue;
      active[at[i]] = 0;
      changed = true;
    }
    for (Index i = 0; i < m; ++i) next[at[i]] = std::max(p[i], 0.0);
    if (std::none_of(active.begin(), active.end(), [](char c) { return c != 0; })) {
      // If no loaded place is left, the place that touches at the least rotation is added.
      Index nearest = 0;
      (q.gap.array() / q.arm.array()).minCoeff(&nearest);
      active[nearest] = 1;
      changed = true;
    }
    const VectorXd displaced = *q.yield * next;
    const double scale = displaced.cwiseAbs().maxCoeff() + std::abs(x.approach) * q.arm.maxCoeff();
    for (Index i = 0; i < n && !(careful && changed); ++i) {
      if (before[i]) continue;
      if (displaced[i] + q.gap[i] - x.approach * q.arm[i] >= -kOverlap * scale) continue;
      active[i] = 1;
      changed = true;
    }
    const double step = (next - x.line_load).cwiseAbs().maxCoeff();
    const double greatest = next.maxCoeff();
    x.line_load = next;
    x.approach_per_gap = VectorXd::Zero(n);
    for (Index i = 0; i < m; ++i) x.approach_per_gap[at[i]] = q.length * turned[i] / stiffness;
    // Under a very small moment, each load is a small difference of large terms, which are
    // caused by the gaps. The load contains the rounding errors of these terms.
    const double cancelling =
        free.cwiseAbs().maxCoeff() + std::abs(x.approach) * turned.cwiseAbs().maxCoeff();
    const double still =
        std::max(kStill * greatest, std::min(kRounding * cancelling, kRough * greatest));
    if (!changed && (q.local == 0.0 || step <= still)) {
      x.stop = ContactSolution::Stop::converged;
      return x;
    }
  }
  return x;
}

// If the gaps change by g', the loads of the loaded places change by p' = a⁻¹ (arm Θ' − g'). [T12.20a]
MatrixXd load_slopes(const ContactProblem& q, const ContactSolution& x,
                     const MatrixXd& gap_slopes) {
  GW_EXPECTS(x.found() && gap_slopes.rows() == q.gap.size());
  std::vector<Index> at;
  for (Index i = 0; i < q.gap.size(); ++i)
    if (x.line_load[i] > 0.0) at.push_back(i);
  const LoadedPlaces e = equations(q, x.line_load, at, mean_load(q));
  const Eigen::RowVectorXd turn = x.approach_per_gap.transpose() * gap_slopes;
  MatrixXd slopes = MatrixXd::Zero(gap_slopes.rows(), gap_slopes.cols());
  const MatrixXd right = e.arm * turn - gap_slopes(at, Eigen::all);
  slopes(at, Eigen::all) = MatrixXd(Eigen::LLT<MatrixXd>(e.a).solve(right));
  return slopes;
}

}  // namespace gearwright
