// Contact of elastic bodies at possible contact positions: each position has either a pressure and
// no gap, or a gap and no pressure.
//
//   w_i(p) + g_i − Θ arm_i = s_i,   p_i ≥ 0,  s_i ≥ 0,  p_i s_i = 0,   Σ p_i Δ arm_i = M2  [T12.2], [T12.3]
//   w_i = Σ_j A_ij p_j + λ ln(a0/a_i) p_i,    a_i = √(4 p_i R_i/(π E*))                       [T12.12]
//
// An active set method with Newton steps [T12.14] removes positions with tension and adds positions
// that overlap. A is symmetric and positive definite and the local term is monotone, so the
// solution is unique.
#pragma once

#include <Eigen/Core>

namespace gearwright {

/// Lengths in mm, forces in N; p is a force per length of the contact line, N/mm.
struct ContactProblem {
  Eigen::MatrixXd yield;         ///< A  mm per N/mm, symmetric
  Eigen::VectorXd gap;           ///< g  mm
  Eigen::VectorXd arm;           ///< mm
  Eigen::VectorXd radius;        ///< R  mm
  double length = 1.0;           ///< Δ  mm, of the contact line in a slice
  double moment = 0.0;           ///< M2  N mm
  double local = 0.0;            ///< λ1/E1 + λ2/E2  mm²/N; 0 without a local term
  double half_width = 1.0;       ///< a0  mm
  double reduced_modulus = 1.0;  ///< E*  N/mm²
};

struct ContactSolution {
  enum class Stop {
    /// True if no position changed and the last step was below 1e-11 of the greatest load, or
    /// within the rounding of gaps that cancel to less than a thousandth of it.
    converged,
    indefinite,  ///< true if the slices are too fine for the contact width, so that the local term makes A indefinite
    too_long
  };
  Stop stop = Stop::too_long;
  Eigen::VectorXd line_load;      ///< p  N/mm
  double approach = 0.0;          ///< Θ  rad
  double yield_per_moment = 0.0;  ///< dΘ/dM2  rad/(N mm): the tangent
  /// ∂Θ/∂g_i  rad/mm, which equals ∂(p_i Δ)/∂M2; 0 without pressure.
  Eigen::VectorXd approach_per_gap;
  int iterations = 0;
  bool found() const { return stop == Stop::converged; }
};

/// `start`: loads to start from, such as those of a similar problem, N/mm; all positions with the
/// same load if empty. It has no influence on the solution except for rounding.
///
/// Domain    at least one place; moment > 0; as many loads as places, none negative (contract)
ContactSolution solve_contact(const ContactProblem& problem, const Eigen::VectorXd& start = {});

/// Half width of a Hertz strip. [T12.12]
double hertz_half_width(double line_load, double radius, double reduced_modulus);

}  // namespace gearwright
