// Square elements with nine nodes and nine Gauss points: the elements of a section mesh.
//
//   x, y   place in an element, −1 … 1      N   its nine functions
//
// Order of the nodes: the corners (−1,−1), (1,−1), (1,1), (−1,1), the sides' middles after them in
// the same turn, the centre.
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
  Slope9 slope;  ///< by x and y
};
Shape9 shape9(double x, double y);

struct GaussPoint {
  double x, y, weight;
};
const std::array<GaussPoint, 9>& gauss9();

/// Gauss' rule with n points on [−1, 1].   Domain: 1 ≤ n ≤ 64 (contract)
struct GaussRule {
  std::vector<double> x, weight;
};
GaussRule gauss_rule(int n);

}  // namespace gearwright::detail
