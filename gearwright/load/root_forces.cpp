#include "gearwright/load/root_forces.hpp"

#include <algorithm>
#include <cstdlib>

namespace gearwright::detail {

using Eigen::Index;
using Eigen::MatrixXd;

double greatest_root_stress(const ToothTable& table, int gear, double module,
                            const std::vector<ToothForces>& forces, MatrixXd& most) {
  const auto points = static_cast<Index>(table.root().t.size());
  if (points == 0) return 0.0;
  const Index n = table.slices();
  if (most.size() == 0) most = MatrixXd::Zero(points, n);
  double greatest = 0.0;
  for (const ToothForces& a : forces) {
    MatrixXd stress = MatrixXd::Zero(6 * points, n);
    for (const ToothForces& b : forces)
      if (const int k = teeth_between(gear, a.pair, b.pair); std::abs(k) <= 1)
        table.add_root_stress(k, b.force, stress);
    for (Index j = 0; j < n; ++j)
      for (Index p = 0; p < points; ++p) {
        const double principal =
            greatest_principal(stress.block<6, 1>(6 * p, j)) / (module * module);
        greatest = std::max(greatest, principal);
        most(p, j) = std::max(most(p, j), principal);
      }
  }
  return greatest;
}

}  // namespace gearwright::detail
