// Root stresses of a gear under the forces on its teeth at one position.
//
// Internal to load/.                                 theory: docs/theory/12-loaded-contact.md, [T12.15]
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gearwright/compliance/tooth_table.hpp"

namespace gearwright::detail {

/// The forces on one tooth of a gear, on the grid of its table, N.
struct ToothForces {
  int pair;  ///< k in N
  Eigen::MatrixXd force;
};

/// The index of the tooth of pair `a` in the section, counted from that of pair `b`. In the
/// section, which is N mirrored, the later tooth of gear 1 is clockwise.
inline int teeth_between(int gear, int a, int b) { return gear == 0 ? b - a : a - b; }

/// Stresses along the fillets over a course of positions, MPa: a row per root point, a column per
/// slice. Empty where the table has no root points.
struct RootSwing {
  Eigen::MatrixXd most;   ///< greatest principal stress, 0 without tension
  Eigen::MatrixXd least;  ///< least principal stress, 0 without compression
};

/// The greatest principal stress along the fillets of the loaded teeth, MPa, 0 where the table has no
/// root points; adds the stresses of these teeth and their neighbours to `swing`.
double greatest_root_stress(const ToothTable& table, int gear, double module,
                            const std::vector<ToothForces>& forces, RootSwing& swing);

}  // namespace gearwright::detail
