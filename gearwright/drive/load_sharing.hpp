// Computes the equilibrium of bodies between one-sided springs, for the load shares of planets.
//
//   x      unknown displacements, mm     y = c·x + y_0   approach of a spring's bodies, mm
//   F(δ)   force of a spring at the approach δ = y + e, 0 if the bodies of the spring do not touch
//   Σ w F c = Q   equilibrium; w weight of a spring, Q load                           [T13.25]
//                                              theory: docs/theory/13-drives.md
//
// The solution is the minimum of a convex energy: Σ w ∫F dδ − Q·x. A body that no spring touches
// does not move.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gearwright/drive/load_spring.hpp"

namespace gearwright::detail {

struct SharingProblem {
  struct Spring {
    const LoadSpring* spring = nullptr;
    Eigen::VectorXd row;   ///< c, approach per displacement
    double offset = 0.0;   ///< y_0 + e  mm, the approach δ at x = 0
    double weight = 1.0;   ///< w; accounts for the efficiencies of the meshes
    double nominal = 0.0;  ///< N, force at the start of the iteration
  };
  std::vector<Spring> springs;
  Eigen::VectorXd load;  ///< Q  N
};

struct SharingSolution {
  enum class Stop {
    converged,    ///< residual ≤ kSharingResidual, or within the rounding of the approaches
    no_progress,  ///< no step reduces the energy
    iterations,   ///< no convergence after kSharingSteps steps
  };
  Eigen::VectorXd x;
  std::vector<double> forces;  ///< N, force of each spring
  double residual = 0.0;       ///< greatest |Σ w F c − Q|, divided by greatest |Q| + Σ |w F c|
  int iterations = 0;
  Stop stop = Stop::iterations;

  bool found() const { return stop == Stop::converged; }
};

/// Greatest residual of a converged solution. Rounding errors in sums over some tens of springs are
/// about a thousand times smaller.
inline constexpr double kSharingResidual = 1e-11;
inline constexpr int kSharingSteps = 200;

/// Computes the displacements and forces at which the bodies are in equilibrium.
///
/// Formula   Newton steps with H = Σ w F′ c cᵀ; a step that passes the minimum along its
///           direction is halved; [T13.25]
/// Laws      a factor of all springs and of Q is also a factor of all forces; a linear problem
///           takes one step
/// Domain    weights > 0; some forces ≥ 0 balance Q, so Q is 0 in every direction that no spring
///           resists (contract)
SharingSolution share_load(const SharingProblem& problem);

/// Solves the same problem, but starts the iteration from the displacements `start`.
SharingSolution share_load(const SharingProblem& problem, Eigen::VectorXd start);

}  // namespace gearwright::detail
