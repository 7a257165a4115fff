#include "gearwright/compliance/section_matrices.hpp"

#include <Eigen/LU>
#include <Eigen/SparseCholesky>

#include "gearwright/base/contract.hpp"

namespace gearwright::detail {

namespace {

using Matrix27 = Eigen::Matrix<double, 27, 27>;

Place9 places(const SectionMesh& mesh, const std::array<int, 9>& e) {
  Place9 x;
  for (int k = 0; k < 9; ++k) {
    x(k, 0) = mesh.nodes[e[k]].real();
    x(k, 1) = mesh.nodes[e[k]].imag();
  }
  return x;
}

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
    // −τΘ:  Θ U = x ∂U/∂y − y ∂U/∂x − e_z × U
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
  const auto n = static_cast<Eigen::Index>(3 * mesh.nodes.size());
  std::array<std::vector<Eigen::Triplet<double>>, 3> entries;
  for (auto& list : entries) list.reserve(mesh.elements.size() * 729);
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
    for (int i = 0; i < 27; ++i)
      for (int j = 0; j < 27; ++j)
        for (int m = 0; m < 3; ++m)
          entries[m].emplace_back(3 * e[i / 3] + i % 3, 3 * e[j / 3] + j % 3, k[m](i, j));
  }
  SectionMatrices out;
  Sparse* const all[3] = {&out.aa, &out.ab, &out.bb};
  for (int m = 0; m < 3; ++m) {
    all[m]->resize(n, n);
    all[m]->setFromTriplets(entries[m].begin(), entries[m].end());
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
    for (int a = 0; a < 9; ++a) {
      const Shape9 s = shape9(kX[a], kY[a]);
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

struct StripSolver::Parts {
  std::vector<Eigen::Index> free;  // dof that are not held
  Sparse k0, k1, k2;               // of those, one pattern
  Eigen::SimplicialLDLT<Sparse, Eigen::Lower, Eigen::AMDOrdering<int>> factor;
  bool analysed = false;
};

StripSolver::StripSolver(const SectionMesh& mesh, const SectionMatrices& wave)
    : parts_(std::make_unique<Parts>()) {
  const Eigen::Index n = wave.aa.rows();
  std::vector<Eigen::Index> place(static_cast<std::size_t>(n), 0);
  for (const int i : mesh.bore)
    for (int c = 0; c < 3; ++c) place[3 * static_cast<std::size_t>(i) + c] = -1;
  for (Eigen::Index i = 0; i < n; ++i)
    if (place[i] == 0) {
      place[i] = static_cast<Eigen::Index>(parts_->free.size());
      parts_->free.push_back(i);
    }
  // The lower triangle. All three matrices have an entry wherever two dof share an element.
  std::vector<Eigen::Triplet<double>> entries[3];
  const Sparse back = wave.ab.transpose();
  const Sparse* const from[3] = {&wave.aa, &wave.ab, &wave.bb};
  for (int m = 0; m < 3; ++m) {
    for (Eigen::Index j = 0; j < n; ++j) {
      if (place[j] < 0) continue;
      Sparse::InnerIterator other(back, j);
      for (Sparse::InnerIterator it(*from[m], j); it; ++it) {
        const double v = m == 1 ? it.value() + other.value() : it.value();
        ++other;
        if (place[it.row()] >= place[j])
          entries[m].emplace_back(static_cast<int>(place[it.row()]), static_cast<int>(place[j]), v);
      }
    }
  }
  const auto size = static_cast<Eigen::Index>(parts_->free.size());
  Sparse* const to[3] = {&parts_->k0, &parts_->k1, &parts_->k2};
  for (int m = 0; m < 3; ++m) {
    to[m]->resize(size, size);
    to[m]->setFromTriplets(entries[m].begin(), entries[m].end());
  }
}

StripSolver::~StripSolver() = default;
StripSolver::StripSolver(StripSolver&&) noexcept = default;

Eigen::MatrixXd StripSolver::solve(double k, const Eigen::MatrixXd& loads) {
  Parts& p = *parts_;
  Sparse matrix = p.k0;
  const Eigen::Index count = matrix.nonZeros();
  using Values = Eigen::Map<Eigen::ArrayXd>;
  Values(matrix.valuePtr(), count) +=
      k * Values(p.k1.valuePtr(), count) + k * k * Values(p.k2.valuePtr(), count);
  if (!p.analysed) p.factor.analyzePattern(matrix);
  p.analysed = true;
  p.factor.factorize(matrix);
  GW_ENSURES(p.factor.info() == Eigen::Success);
  Eigen::MatrixXd right(static_cast<Eigen::Index>(p.free.size()), loads.cols());
  for (std::size_t i = 0; i < p.free.size(); ++i) right.row(i) = loads.row(p.free[i]);
  const Eigen::MatrixXd x = p.factor.solve(right);
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(loads.rows(), loads.cols());
  for (std::size_t i = 0; i < p.free.size(); ++i) out.row(p.free[i]) = x.row(i);
  return out;
}

}  // namespace gearwright::detail
