#include "gearwright/compliance/section_matrices.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "gearwright/base/contract.hpp"

namespace gearwright::detail {

namespace {

using Matrix27 = Eigen::Matrix<double, 27, 27>;

// Slopes are computed at a node if the Jacobian determinant there is at least this fraction of the
// determinant in the middle of the element.
constexpr double kPoint = 1e-4;

Place9 places(const SectionMesh& mesh, const std::array<int, 9>& e) {
  Place9 x;
  for (int k = 0; k < 9; ++k) {
    x(k, 0) = mesh.nodes[e[k]].real();
    x(k, 1) = mesh.nodes[e[k]].imag();
  }
  return x;
}

// The sparsity pattern of the stiffness matrices. Nodes that share an element have a 3 × 3 block.
class BlockPattern {
 public:
  explicit BlockPattern(const SectionMesh& mesh) : beside_(mesh.nodes.size()) {
    for (const auto& e : mesh.elements)
      for (const int j : e) beside_[j].insert(beside_[j].end(), e.begin(), e.end());
    first_.push_back(0);
    for (auto& list : beside_) {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
      for (int c = 0; c < 3; ++c)
        first_.push_back(first_.back() + 3 * static_cast<int>(list.size()));
    }
  }
  // Returns the index of the first of the three rows of node i, in column c of node j.
  Eigen::Index place(int i, int j, int c) const {
    const auto& list = beside_[j];
    const auto rank = std::lower_bound(list.begin(), list.end(), i) - list.begin();
    return first_[3 * static_cast<std::size_t>(j) + c] + 3 * rank;
  }
  Sparse zeros() const {
    const auto n = static_cast<Eigen::Index>(first_.size()) - 1;
    Sparse m(n, n);
    m.resizeNonZeros(first_.back());
    std::copy(first_.begin(), first_.end(), m.outerIndexPtr());
    int* row = m.innerIndexPtr();
    for (const auto& list : beside_)
      for (int c = 0; c < 3; ++c)
        for (const int i : list)
          for (int r = 0; r < 3; ++r) *row++ = 3 * i + r;
    std::fill_n(m.valuePtr(), first_.back(), 0.0);
    return m;
  }

 private:
  std::vector<std::vector<int>> beside_;
  std::vector<int> first_;  // index of the first entry of each column
};

}  // namespace

Matrix6 hooke(double youngs_modulus, double poisson_ratio) {
  const double nu = poisson_ratio;
  GW_EXPECTS(nu >= 0.0 && nu < 0.5);
  const double lambda = youngs_modulus * nu / ((1 + nu) * (1 - 2 * nu));
  const double g = youngs_modulus / (2 * (1 + nu));
  Matrix6 d = Matrix6::Zero();
  d.topLeftCorner<3, 3>().setConstant(lambda);
  for (int i = 0; i < 3; ++i) {
    d(i, i) += 2 * g;
    d(i + 3, i + 3) = g;
  }
  return d;
}

StrainPair element_strains(const Node9& value, const Slope9& slope, const Eigen::RowVector2d& at,
                           double tau, double shear_sign) {
  StrainPair strain;
  auto& [a, b] = strain;
  a.setZero();
  b.setZero();
  for (int k = 0; k < 9; ++k) {
    const int u = 3 * k;
    const double x = slope(0, k);
    const double y = slope(1, k);
    a(0, u) = x;
    a(1, u + 1) = y;
    a(3, u) = y;
    a(3, u + 1) = x;
    a(4, u + 2) = y;
    a(5, u + 2) = x;
    b(2, u + 2) = value[k];
    b(4, u + 1) = shear_sign * value[k];
    b(5, u) = shear_sign * value[k];
    if (tau == 0.0) continue;
    // For a helical gear, ∂/∂z is replaced by ∂/∂z − τΘ, where Θ U = x ∂U/∂y − y ∂U/∂x − e_z × U.
    const double turn = at[0] * y - at[1] * x;
    a(2, u + 2) -= tau * turn;
    a(4, u + 1) -= tau * turn;
    a(4, u) += tau * value[k];
    a(5, u) -= tau * turn;
    a(5, u + 1) -= tau * value[k];
  }
  return strain;
}

SectionMatrices section_matrices(const SectionMesh& mesh, const Matrix6& law, double tau,
                                 bool wave) {
  const BlockPattern pattern(mesh);
  SectionMatrices out;
  const std::array<Sparse*, 3> all{&out.aa, &out.ab, &out.bb};
  for (Sparse* m : all) *m = pattern.zeros();
  for (const auto& e : mesh.elements) {
    const Place9 x = places(mesh, e);
    std::array<Matrix27, 3> k{Matrix27::Zero(), Matrix27::Zero(), Matrix27::Zero()};
    for (const GaussPoint& p : gauss9()) {
      const Shape9 s = shape9(p.x, p.y);
      const Eigen::Matrix2d jacobian = s.slope * x;
      const Slope9 slope = jacobian.inverse() * s.slope;
      const double weight = p.weight * jacobian.determinant();
      const auto [a, b] =
          element_strains(s.value, slope, s.value.transpose() * x, tau, wave ? -1.0 : 1.0);
      const Eigen::Matrix<double, 6, 27> da = weight * (law * a);
      const Eigen::Matrix<double, 6, 27> db = weight * (law * b);
      k[0].noalias() += a.transpose() * da;
      k[1].noalias() += a.transpose() * db;
      k[2].noalias() += b.transpose() * db;
    }
    for (int j = 0; j < 9; ++j)
      for (int i = 0; i < 9; ++i)
        for (int c = 0; c < 3; ++c) {
          const Eigen::Index at = pattern.place(e[i], e[j], c);
          for (int m = 0; m < 3; ++m)
            for (int r = 0; r < 3; ++r) all[m]->valuePtr()[at + r] += k[m](3 * i + r, 3 * j + c);
        }
  }
  return out;
}

Eigen::MatrixXd trace_fields(const SectionMesh& mesh, const Eigen::MatrixXd& fields) {
  static constexpr double kX[9] = {-1, 1, 1, -1, 0, 1, 0, -1, 0};
  static constexpr double kY[9] = {-1, -1, 1, 1, -1, 0, 1, 0, 0};
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(fields.rows(), fields.cols());
  std::vector<int> count(mesh.nodes.size(), 0);
  for (const auto& e : mesh.elements) {
    const Place9 x = places(mesh, e);
    const double middle = (shape9(0.0, 0.0).slope * x).determinant();
    for (int a = 0; a < 9; ++a) {
      Shape9 s = shape9(kX[a], kY[a]);
      // At the tip of a pointed tooth, one side of the element has no length. On this side, the
      // slopes in the middle of the element are used.
      if ((s.slope * x).determinant() < kPoint * middle) s = shape9(0.0, 0.0);
      const Slope9 slope = (s.slope * x).inverse() * s.slope;
      for (int k = 0; k < 9; ++k) {
        out.row(3 * e[a] + 2) += slope(0, k) * fields.row(3 * e[k]);
        out.row(3 * e[a] + 2) += slope(1, k) * fields.row(3 * e[k] + 1);
      }
      ++count[e[a]];
    }
  }
  for (std::size_t i = 0; i < count.size(); ++i) out.row(3 * i + 2) /= count[i];
  for (const int i : mesh.bore) out.row(3 * i + 2).setZero();
  return out;
}

}  // namespace gearwright::detail
