// Computes the root stresses of a gear under the forces on its teeth at one position.
//
// Internal to load/.                      theory: docs/theory/12-loaded-contact.md, [T12.15]
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gearwright/compliance/tooth_table.hpp"

namespace gearwright::detail {

/// The forces on one tooth of a gear, on the grid of its table, N.
struct ToothForces {
  int pair;  ///< k, number of the tooth pair in the frame N
  Eigen::MatrixXd force;
};

/// Returns the index of the tooth of pair `a` in the section, counted counter-clockwise from the
/// tooth of pair `b`. In the section, a tooth of gear 1 has a lower index than the teeth that come
/// into contact before it.
inline int teeth_between(int gear, int a, int b) { return gear == 0 ? b - a : a - b; }

/// Extreme stresses along the fillets over several positions, MPa. There is a row per root point
/// and a column per slice. The matrices are empty if the table has no root points.
struct RootSwing {
  Eigen::MatrixXd most;   ///< greatest principal stress, 0 without tension
  Eigen::MatrixXd least;  ///< least principal stress, 0 without compression
};

/// Returns the greatest principal stress along the fillets of the loaded teeth and their
/// neighbours, MPa, or 0 if the table has no root points. `swing` is widened to include the
/// stresses of all these teeth.
double greatest_root_stress(const ToothTable& table, int gear, double module,
                            const std::vector<ToothForces>& forces, RootSwing& swing);

}  // namespace gearwright::detail
