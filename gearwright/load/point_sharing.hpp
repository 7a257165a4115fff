// Computes the forces at the contact points of elastic bodies that carry a moment together.
//
//   δ_i + Σ_j G_ij F_j + g_i − Θ arm_i = 0,   F_i = (max(δ_i, 0)/c_i)^(3/2),   Σ F_i arm_i = M2
//                                                                                    [T12.24]
//
//   Θ      rotation of gear 2 beyond rigid contact   arm_i   normal gap per rad of Θ
//   g_i    gap without load                          G_ij    compliance of the bodies
//
// If point i carries load, δ_i is its Hertz approach. Otherwise, −δ_i is the remaining gap. The
// forces minimise a strictly convex energy, so the solution is unique.
#pragma once

#include <Eigen/Core>

namespace gearwright {

/// Lengths in mm, forces in N.
struct PointProblem {
  /// G  mm/N, symmetric: compliance of the bodies without the Hertz contact.
  Eigen::MatrixXd yield;
  Eigen::VectorXd gap;       ///< g  mm
  Eigen::VectorXd arm;       ///< mm
  Eigen::VectorXd softness;  ///< c  mm/N^(2/3)
  double moment = 0.0;       ///< M2  N mm
};

struct PointSharing {
  Eigen::VectorXd force;          ///< N
  double approach = 0.0;          ///< Θ  rad
  double yield_per_moment = 0.0;  ///< dΘ/dM2  rad/(N mm)
  int iterations = 0;
  bool found = false;
};

/// Computes the forces by Newton's method. A step is halved until the residual decreases.
///
/// Domain    at least one point; moment, arm, softness > 0; G positive semidefinite (contract)
PointSharing share_points(const PointProblem& problem);

}  // namespace gearwright
