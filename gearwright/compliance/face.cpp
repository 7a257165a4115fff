#include "gearwright/compliance/face.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/compliance/q9.hpp"

namespace gearwright::detail {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMinElements = 4;

const std::array<double, 4>& lobatto() {
  static const std::array<double, 4> x{-1.0, -1 / std::sqrt(5.0), 1 / std::sqrt(5.0), 1.0};
  return x;
}

double lagrange(int i, double x) {
  const auto& p = lobatto();
  double v = 1.0;
  for (int j = 0; j < 4; ++j)
    if (j != i) v *= (x - p[j]) / (p[i] - p[j]);
  return v;
}

double lagrange_slope(int i, double x) {
  const auto& p = lobatto();
  double sum = 0.0;
  for (int m = 0; m < 4; ++m) {
    if (m == i) continue;
    double v = 1 / (p[i] - p[m]);
    for (int j = 0; j < 4; ++j)
      if (j != i && j != m) v *= (x - p[j]) / (p[i] - p[j]);
    sum += v;
  }
  return sum;
}

}  // namespace

// The stiffness matrices of an element after elimination of the inner nodes (i), which leaves the
// ends (e). r is the number of modes.
struct Face::Element {
  Eigen::LLT<MatrixXd> inner;  // 2r × 2r
  MatrixXd inner_to_ends;      // K_ie
  MatrixXd recovered;          // K_ii⁻¹ K_ie
  MatrixXd ends;               // K_ee − K_ei K_ii⁻¹ K_ie
};

Face::Face(const ModeMatrices& modes, double width, double element)
    : modes_(static_cast<int>(modes.aa.rows())) {
  GW_EXPECTS(width > 0.0 && element > 0.0);
  const int n = std::max(kMinElements, static_cast<int>(std::ceil(width / element)));
  for (int i = 0; i <= n; ++i) ends_.push_back(width * (double(i) / n - 0.5));
  for (int e = 0; e < n; ++e)
    for (int i = 0; i < kDegree; ++i)
      nodes_.push_back(ends_[e] + 0.5 * (ends_[e + 1] - ends_[e]) * (lobatto()[i] + 1));
  nodes_.push_back(ends_.back());

  const GaussRule rule = gauss_rule(kDegree + 1);
  const Index r = modes_;
  auto made = std::make_unique<Element>();
  const double half = 0.5 * (width / n);
  MatrixXd all(4 * r, 4 * r);
  const std::array<int, 4> place{2, 0, 1, 3};  // the inner nodes are numbered first
  for (int a = 0; a < 4; ++a) {
    for (int b = 0; b < 4; ++b) {
      double m00 = 0.0;
      double m01 = 0.0;
      double m10 = 0.0;
      double m11 = 0.0;
      for (std::size_t g = 0; g < rule.x.size(); ++g) {
        const double w = rule.weight[g];
        const double x = rule.x[g];
        m00 += w * lagrange(a, x) * lagrange(b, x) * half;
        m01 += w * lagrange(a, x) * lagrange_slope(b, x);
        m10 += w * lagrange_slope(a, x) * lagrange(b, x);
        m11 += w * lagrange_slope(a, x) * lagrange_slope(b, x) / half;
      }
      all.block(place[a] * r, place[b] * r, r, r) =
          m00 * modes.aa + m01 * modes.ab + m10 * modes.ab.transpose() + m11 * modes.bb;
    }
  }
  made->inner.compute(all.topLeftCorner(2 * r, 2 * r));
  GW_ENSURES(made->inner.info() == Eigen::Success);
  made->inner_to_ends = all.topRightCorner(2 * r, 2 * r);
  made->recovered = made->inner.solve(made->inner_to_ends);
  made->ends = all.bottomRightCorner(2 * r, 2 * r);
  made->ends.noalias() -= made->inner_to_ends.transpose() * made->recovered;
  element_ = std::move(made);

  MatrixXd carried = MatrixXd::Zero(r, r);
  for (int i = 0; i <= n; ++i) {
    MatrixXd block = carried;
    if (i < n) block += element_->ends.topLeftCorner(r, r);
    if (i > 0) block += element_->ends.bottomRightCorner(r, r);
    const Eigen::LLT<MatrixXd> llt(block);
    GW_ENSURES(llt.info() == Eigen::Success);
    factor_.push_back(llt.matrixL());
    if (i == n) break;
    // O is the block of the system matrix below the diagonal block of this node. At the same
    // position, the factor contains the block M = O L⁻ᵀ.
    const MatrixXd transposed =
        factor_.back().triangularView<Eigen::Lower>().solve(element_->ends.topRightCorner(r, r));
    below_.push_back(transposed.transpose());
    // The Cholesky decomposition reads the lower triangle only.
    carried.setZero();
    carried.selfadjointView<Eigen::Lower>().rankUpdate(below_.back(), -1.0);
  }
}

Face::~Face() = default;

VectorXd Face::shape(double z, bool slope) const {
  const auto it = std::upper_bound(ends_.begin() + 1, ends_.end() - 1, z);
  const auto e = static_cast<Index>(it - ends_.begin()) - 1;
  const double half = 0.5 * (ends_[e + 1] - ends_[e]);
  const double x = (z - ends_[e]) / half - 1;
  VectorXd v = VectorXd::Zero(node_count());
  for (int i = 0; i < 4; ++i)
    v[e * kDegree + i] = slope ? lagrange_slope(i, x) / half : lagrange(i, x);
  return v;
}

VectorXd Face::at(double z) const { return shape(z, false); }
VectorXd Face::slope_at(double z) const { return shape(z, true); }

VectorXd Face::mean(double lo, double hi) const {
  static const GaussRule rule = gauss_rule(4);
  VectorXd v = VectorXd::Zero(node_count());
  for (std::size_t e = 0; e + 1 < ends_.size(); ++e) {
    const double a = std::max(lo, ends_[e]);
    const double b = std::min(hi, ends_[e + 1]);
    if (!(b > a)) continue;
    for (std::size_t g = 0; g < rule.x.size(); ++g)
      v += 0.5 * (b - a) / (hi - lo) * rule.weight[g] *
           at(0.5 * (a + b) + 0.5 * (b - a) * rule.x[g]);
  }
  return v;
}

const MatrixXd& Face::recovered() const { return element_->recovered; }

Face::Loads Face::loads(const MatrixXd& on_modes) const {
  const Index r = modes_;
  GW_EXPECTS(on_modes.rows() == r);
  Loads l{on_modes, {}, {}};
  for (const int b : {0, 1}) {
    l.at_ends[b] = element_->recovered.middleRows(b * r, r).transpose() * on_modes;
    l.inner[b] = MatrixXd::Zero(2 * r, on_modes.cols());
    l.inner[b].middleRows(b * r, r) = on_modes;
    element_->inner.solveInPlace(l.inner[b]);
  }
  return l;
}

MatrixXd Face::solve(const Loads& loads, int load, const MatrixXd& along) const {
  GW_EXPECTS(along.rows() == node_count());
  const Index r = modes_, n = element_count(), columns = along.cols();
  MatrixXd x = MatrixXd::Zero((n + 1) * r, columns);
  // For each column, the first end that is loaded in this or a later column.
  std::vector<Index> first(columns, n);
  for (Index j = 0; j < columns; ++j) {
    for (Index i = n; i >= 0; --i) {
      if (const double f = along(i * kDegree, j); f != 0.0) {
        x.block(i * r, j, r, 1) += f * loads.at_node.col(load);
        first[j] = i;
      }
      if (i == n) continue;
      for (const int b : {0, 1}) {
        const double f = along(i * kDegree + 1 + b, j);
        if (f == 0.0) continue;
        x.block(i * r, j, 2 * r, 1) -= f * loads.at_ends[b].col(load);
        first[j] = i;
      }
    }
  }
  for (Index j = columns - 1; j > 0; --j) first[j - 1] = std::min(first[j - 1], first[j]);
  // The elimination from the first end on includes only the columns whose load it has reached.
  Index reached = 0;
  for (Index i = 0; i <= n; ++i) {
    if (i > 0)
      x.block(i * r, 0, r, reached).noalias() -=
          below_[i - 1] * x.block((i - 1) * r, 0, r, reached);
    while (reached < columns && first[reached] <= i) ++reached;
    auto here = x.block(i * r, 0, r, reached);
    factor_[i].triangularView<Eigen::Lower>().solveInPlace(here);
  }
  for (Index i = n; i >= 0; --i) {
    auto here = x.middleRows(i * r, r);
    if (i < n) here.noalias() -= below_[i].transpose() * x.middleRows((i + 1) * r, r);
    factor_[i].triangularView<Eigen::Lower>().transpose().solveInPlace(here);
  }
  return x;
}

}  // namespace gearwright::detail
