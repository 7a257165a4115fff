#include "gearwright/compliance/face_reading.hpp"

#include <array>
#include <utility>

#include "gearwright/base/contract.hpp"

namespace gearwright::detail {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

FaceReading::Part FaceReading::part(const Face::Loads& loads, MatrixXd of_node) const {
  const Index r = face_.mode_count();
  Part p;
  if (of_node.size() == 0) return p;
  GW_EXPECTS(of_node.cols() == r);
  for (const int a : {0, 1}) {
    p.of_ends[a].noalias() = of_node * face_.recovered().middleRows(a * r, r);
    for (const int b : {0, 1})
      p.of_load[a][b].noalias() = of_node * loads.inner[b].middleRows(a * r, r);
  }
  p.of_node = std::move(of_node);
  return p;
}

FaceReading::FaceReading(const Face& face, const Face::Loads& loads, MatrixXd of_value,
                         MatrixXd of_slope)
    : face_(face),
      value_(part(loads, std::move(of_value))),
      slope_(part(loads, std::move(of_slope))) {}

MatrixXd FaceReading::at(const VectorXd& value, const VectorXd& slope, const MatrixXd& along,
                         const MatrixXd& ends) const {
  using Weights = std::array<double, Face::kDegree + 1>;
  const Index r = face_.mode_count(), n = face_.element_count(), columns = along.cols();
  const Index rows = value_.of_node.rows();
  MatrixXd out = MatrixXd::Zero(rows, ends.cols());
  MatrixXd of_ends(rows, 2 * r);
  VectorXd under_load(rows);
  // If an end belongs to two elements that both have weights, its weight is used in the first one.
  bool left_used = false;
  for (Index e = 0; e < n; ++e) {
    const Index first = e * Face::kDegree;
    const auto weights = [&](const VectorXd& of) {
      Weights w{};
      if (of.size() == 0) return w;
      for (int a = left_used ? 1 : 0; a <= Face::kDegree; ++a) w[a] = of[first + a];
      return w;
    };
    const auto is_read = [&](const Weights& w) {
      return w[0] != 0.0 || w[1] != 0.0 || w[2] != 0.0 || (e == n - 1 && w[3] != 0.0);
    };
    const Weights v = weights(value), s = weights(slope);
    left_used = is_read(v) || is_read(s);
    if (!left_used) continue;
    of_ends.setZero();
    const auto add = [&](const Part& p, const Weights& w) {
      if (p.of_node.size() == 0) return;
      of_ends.leftCols(r) += w[0] * p.of_node;
      of_ends.rightCols(r) += w[3] * p.of_node;
      of_ends -= w[1] * p.of_ends[0] + w[2] * p.of_ends[1];
      for (const int b : {0, 1}) {
        const auto load = along.row(first + 1 + b);
        if (load.isZero(0.0)) continue;
        for (Index i = 0; i < p.of_load[0][b].cols(); ++i) {
          under_load = w[1] * p.of_load[0][b].col(i) + w[2] * p.of_load[1][b].col(i);
          for (Index j = 0; j < columns; ++j)
            if (load[j] != 0.0) out.col(i * columns + j) += load[j] * under_load;
        }
      }
    };
    add(value_, v);
    add(slope_, s);
    out.noalias() += of_ends * ends.middleRows(e * r, 2 * r);
  }
  return out;
}

}  // namespace gearwright::detail
