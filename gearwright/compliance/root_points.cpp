#include "gearwright/compliance/root_points.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "gearwright/compliance/q9.hpp"

namespace gearwright::detail {

RootPoints root_points(const ToothSection& section) {
  const SectionMesh& mesh = section.mesh;
  const Eigen::MatrixXd& phi = section.modes.fields;
  const Eigen::Index r = phi.cols();
  const Matrix6 law = hooke(1.0, section.poisson_ratio);
  RootPoints points;
  // The points are the ends and middles of the elements along the fillet. Where two elements meet,
  // the mean of the stresses of both elements is used.
  const int first = 2 * mesh.fillet_begin;
  const int last = 2 * mesh.flank_begin;
  for (int i = first; i <= last; ++i) {
    points.t.push_back(0.5 * i);
    points.place.push_back(mesh.outline(0.5 * i));
  }
  const auto count = static_cast<Eigen::Index>(points.t.size());
  points.of_mode = points.of_slope = Eigen::MatrixXd::Zero(3 * 6 * count, r);
  for (int k = -1; k <= 1; ++k) {
    auto a = points.of_mode.middleRows(6 * count * (k + 1), 6 * count);
    auto b = points.of_slope.middleRows(6 * count * (k + 1), 6 * count);
    const auto& edges = mesh.tooth_edges[mesh.side_teeth + k];
    const auto add = [&](Eigen::Index point, const SectionMesh::Edge& edge, double x,
                         double weight) {
      const auto& e = mesh.elements[edge.element];
      const Shape9 s = shape9(edge.forward ? x : -x, -1.0);
      Place9 at;
      for (int n = 0; n < 9; ++n) {
        at(n, 0) = mesh.nodes[e[n]].real();
        at(n, 1) = mesh.nodes[e[n]].imag();
      }
      const Slope9 slope = (s.slope * at).inverse() * s.slope;
      const StrainPair strain =
          element_strains(s.value, slope, s.value.transpose() * at, section.tau, 1.0);
      Eigen::MatrixXd nodal(27, r);
      for (int n = 0; n < 9; ++n) nodal.middleRows<3>(3 * n) = phi.middleRows<3>(3 * e[n]);
      a.middleRows<6>(6 * point) += weight * (law * strain.a) * nodal;
      b.middleRows<6>(6 * point) += weight * (law * strain.b) * nodal;
    };
    for (Eigen::Index i = 0; i < count; ++i) {
      const double t = points.t[i];
      const auto whole = static_cast<std::size_t>(std::floor(t));
      if (t != double(whole)) {
        add(i, edges[whole], 0.0, 1.0);
        continue;
      }
      const bool before = whole > 0;
      const bool after = whole < edges.size();
      const double weight = before && after ? 0.5 : 1.0;
      if (before) add(i, edges[whole - 1], 1.0, weight);
      if (after) add(i, edges[whole], -1.0, weight);
    }
  }
  return points;
}

double greatest_principal(const Eigen::Matrix<double, 6, 1>& s) {
  // The greatest root of the characteristic polynomial in trigonometric form (Lode angle).
  const double mean = (s[0] + s[1] + s[2]) / 3;
  const double x = s[0] - mean;
  const double y = s[1] - mean;
  const double z = s[2] - mean;
  const double half_j2 =
      (x * x + y * y + z * z) / 6 + (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]) / 3;
  if (!(half_j2 > 0.0)) return mean;
  const double det =
      x * (y * z - s[4] * s[4]) - s[3] * (s[3] * z - s[4] * s[5]) + s[5] * (s[3] * s[4] - y * s[5]);
  const double p = std::sqrt(half_j2);
  const double angle = std::acos(std::clamp(0.5 * det / (p * p * p), -1.0, 1.0)) / 3;
  return mean + 2 * p * std::cos(angle);
}

}  // namespace gearwright::detail
