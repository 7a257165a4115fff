#include "gearwright/compliance/shaft_influence.hpp"

#include <algorithm>
#include <vector>

namespace gearwright {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd column_of(const std::vector<double>& list) {
  return Eigen::Map<const VectorXd>(list.data(), static_cast<Eigen::Index>(list.size()));
}

MatrixXd both_orders(const MatrixXd& a, const MatrixXd& b) { return (a + b.transpose()) / 2; }

}  // namespace

ShaftInfluence shaft_influence(const Shaft& shaft, const FaceSlices& slices, double body) {
  const int n = slices.count;
  const double h = slices.width();
  std::vector<double> middles;
  for (int i = 0; i < n; ++i) middles.push_back(slices.middle(i));
  ShaftInfluence all;
  all.force = all.moment = all.turn = all.twist = MatrixXd::Zero(n, n);
  MatrixXd slope(n, n);  // ψ due to a force
  for (int j = 0; j < n; ++j) {
    const double lo = slices.lo + j * h;
    const ShaftDeflection by_force = shaft_deflection(shaft, {1.0, 0.0, lo, lo + h}, middles);
    const ShaftDeflection by_moment = shaft_deflection(shaft, {0.0, 1.0, lo, lo + h}, middles);
    all.force.col(j) = column_of(by_force.w);
    slope.col(j) = column_of(by_force.slope);
    all.moment.col(j) = column_of(by_moment.w);
    all.turn.col(j) = column_of(by_moment.slope);
  }
  all.force = both_orders(all.force, all.force);
  all.turn = both_orders(all.turn, all.turn);
  all.moment = both_orders(all.moment, slope);
  // A torque on slice j twists the gear between this slice and the end at which the torque leaves.
  const bool left = shaft.torque_from == ShaftSide::left;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const int steps = left ? std::min(i, j) : n - 1 - std::max(i, j);
      // Within slice j, the torque decreases linearly to 0. Slice j therefore twists like half of a
      // slice under the whole torque, and up to its middle like 0.375 of a slice.
      all.twist(i, j) = (steps + (i == j ? 0.375 : 0.5)) * h;
    }
  all.twist *= shaft_twist_per_length(shaft, body);
  return all;
}

}  // namespace gearwright
