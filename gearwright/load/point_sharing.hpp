// Elastic bodies that touch at a few points: how the points share a moment.
//
//   δ_i + Σ_j G_ij F_j + g_i − Θ arm_i = 0,   F_i = (max(δ_i, 0)/c_i)^(3/2),   Σ F_i arm_i = M2   [T12.24]
//
// δ_i is the approach of Hertz where point i carries load, and minus the remaining gap where it
// does not, so one formula covers both. F minimises a strictly convex energy, so the solution is
// unique.
#pragma once

#include <Eigen/Core>

namespace gearwright {

/// Lengths in mm, forces in N.
struct PointProblem {
  Eigen::MatrixXd yield;     ///< G  mm/N, symmetric, of the bodies without the contact itself
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

/// Newton steps that never raise the residual.
///
/// Domain    at least one point; moment, arms, softness > 0; G positive semidefinite (contract)
PointSharing share_points(const PointProblem& problem);

}  // namespace gearwright
