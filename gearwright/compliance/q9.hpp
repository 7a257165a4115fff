// The shape functions of the quadrilateral elements of the section mesh, which have nine nodes and
// nine Gauss points.
//
//   x, y   coordinates in an element, −1 … 1      N   the nine shape functions
//
// The nodes are ordered as follows: the corners (−1,−1), (1,−1), (1,1), (−1,1), then the middles of
// the sides in the same sense of rotation, then the centre.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace gearwright::detail {

using Node9 = Eigen::Matrix<double, 9, 1>;
using Slope9 = Eigen::Matrix<double, 2, 9>;
using Place9 = Eigen::Matrix<double, 9, 2>;

struct Shape9 {
  Node9 value;
  Slope9 slope;  ///< derivatives with respect to x and y
};
Shape9 shape9(double x, double y);

struct GaussPoint {
  double x, y, weight;
};
const std::array<GaussPoint, 9>& gauss9();

/// A quadrature rule on [−1, 1].
struct GaussRule {
  std::vector<double> x, weight;
};
/// Returns the Gauss–Legendre rule with n points.   Domain: 1 ≤ n ≤ 64 (contract)
GaussRule gauss_rule(int n);

}  // namespace gearwright::detail
