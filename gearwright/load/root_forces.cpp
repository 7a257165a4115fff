#include "gearwright/load/root_forces.hpp"

#include <algorithm>
#include <cstdlib>

#include "gearwright/base/lists.hpp"

namespace gearwright::detail {

using Eigen::Index;
using Eigen::MatrixXd;

namespace {

// Returns the loaded teeth, followed by their unloaded neighbours, which also deform.
std::vector<int> teeth_that_feel(const std::vector<ToothForces>& forces) {
  std::vector<int> teeth;
  for (const ToothForces& f : forces) add_once(teeth, f.pair);
  for (const ToothForces& f : forces)
    for (const int beside : {-1, 1}) add_once(teeth, f.pair + beside);
  return teeth;
}

double least_principal(const Eigen::Matrix<double, 6, 1>& stress) {
  return -greatest_principal(-stress);
}

}  // namespace

double greatest_root_stress(const ToothTable& table, int gear, double module,
                            const std::vector<ToothForces>& forces, RootSwing& swing) {
  const auto points = static_cast<Index>(table.root().t.size());
  if (points == 0) return 0.0;
  const Index n = table.slices();
  if (swing.most.size() == 0) swing = {MatrixXd::Zero(points, n), MatrixXd::Zero(points, n)};
  double greatest = 0.0;
  for (const int tooth : teeth_that_feel(forces)) {
    MatrixXd stress = MatrixXd::Zero(6 * points, n);
    for (const ToothForces& f : forces)
      if (const int k = teeth_between(gear, tooth, f.pair); std::abs(k) <= 1)
        table.add_root_stress(k, f.force, stress);
    for (Index j = 0; j < n; ++j)
      for (Index p = 0; p < points; ++p) {
        const Eigen::Matrix<double, 6, 1> here = stress.block<6, 1>(6 * p, j);
        const double principal = greatest_principal(here) / (module * module);
        greatest = std::max(greatest, principal);
        swing.most(p, j) = std::max(swing.most(p, j), principal);
        swing.least(p, j) = std::min(swing.least(p, j), least_principal(here) / (module * module));
      }
  }
  return greatest;
}

}  // namespace gearwright::detail
