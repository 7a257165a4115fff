// Computes the loads of elastic bodies at the places where they can touch. Each place has either a
// load and no gap, or a gap and no load.
//
//   p_i    load per length of the contact line               g_i, s_i   gap without and under load
//   Θ      rotation of gear 2 beyond rigid contact           arm_i      normal gap per rad of Θ
//   λ      λ1/E1 + λ2/E2, factor of the local deformation    w_i        deflection at place i
//
//   w_i(p) + g_i − Θ arm_i = s_i,   p_i ≥ 0,  s_i ≥ 0,  p_i s_i = 0,   Σ p_i Δ arm_i = M2
//                                                                            [T12.2], [T12.3]
//   w_i = Σ_j A_ij p_j + λ ln(a0/a_i) p_i,    a_i = √(4 p_i R_i/(π E*))      [T12.12]
//
// The loads are computed by an active set method with Newton steps [T12.14]. Each step removes
// places with tension from the set of loaded places, and adds places at which the bodies overlap.
// The solution is unique: A is symmetric and positive definite, and the local term is monotone.
#pragma once

#include <Eigen/Core>
#include <memory>

namespace gearwright {

/// Lengths in mm, forces in N; p is a force per length of the contact line, N/mm.
struct ContactProblem {
  std::shared_ptr<const Eigen::MatrixXd> yield;  ///< A  mm per N/mm, symmetric
  Eigen::VectorXd gap;                           ///< g  mm
  Eigen::VectorXd arm;                           ///< mm
  Eigen::VectorXd radius;        ///< R  mm, 1/curvature of the gap across the contact line
  double length = 1.0;           ///< Δ  mm, length of the contact line at each place
  double moment = 0.0;           ///< M2  N mm
  double local = 0.0;            ///< λ1/E1 + λ2/E2  mm²/N; 0 without a local term
  double half_width = 1.0;       ///< a0  mm, half width of the strip for which A is computed
  double reduced_modulus = 1.0;  ///< E*  N/mm²
};

struct ContactSolution {
  enum class Stop {
    /// The set of loaded places did not change and, with a local term, the last step was small. A
    /// step is small if it is below 1e-11 of the greatest load, or below the rounding error that is
    /// caused by cancelling terms. A rounding error of up to a thousandth of the greatest load is
    /// accepted.
    converged,
    indefinite,  ///< A is indefinite, because the slices are too fine for the contact width
    too_long     ///< the limit of steps was reached, or a number is not finite
  };
  Stop stop = Stop::too_long;
  Eigen::VectorXd line_load;      ///< p  N/mm
  double approach = 0.0;          ///< Θ  rad
  double yield_per_moment = 0.0;  ///< dΘ/dM2  rad/(N mm), tangent compliance
  /// ∂Θ/∂g_i  rad/mm, which equals ∂(p_i Δ)/∂M2; 0 at places without load.
  Eigen::VectorXd approach_per_gap;
  int iterations = 0;
  bool found() const { return stop == Stop::converged; }
};

/// Solves the problem. The iteration starts from the loads `start`, N/mm, for example from the
/// solution of a similar problem. If `start` is empty or contains no load > 0, all places start
/// with the same load. Apart from rounding errors, the solution does not depend on `start`.
///
/// Domain    at least one place; moment > 0; one start load ≥ 0 for each place (contract)
ContactSolution solve_contact(const ContactProblem& problem, const Eigen::VectorXd& start = {});

/// Returns ∂p/∂e, a row for each place and a column for each variable e, if the gaps have the
/// derivatives ∂g/∂e = `gap_slopes`. The places with load keep their load or lose a part of it, and
/// no other place receives load.
///
/// Domain    a solution of the problem that was found; a row of `gap_slopes` for each place
///           (contract)
Eigen::MatrixXd load_slopes(const ContactProblem& problem, const ContactSolution& solution,
                            const Eigen::MatrixXd& gap_slopes);

/// Returns the half width of a Hertz strip, mm. [T12.12]
double hertz_half_width(double line_load, double radius, double reduced_modulus);

}  // namespace gearwright
