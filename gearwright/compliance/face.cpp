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

constexpr int kDegree = 3;
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

// A range of columns, begin … begin + count − 1. All columns of a matrix of loads outside the range
// are zero. The range must consist of whole panels of kPanel columns and must have more than one
// column. Only then does Eigen add up the terms of a product in the same order as for the whole
// matrix. With other ranges, columns of zeros would change the rounding of the other columns.
struct LoadedColumns {
  Index begin = 0, count = 0;

  void include(const Eigen::Ref<const MatrixXd>& loads) {
    constexpr Index kPanel = 4;
    Index first = 0, end = loads.cols();
    while (end > 0 && loads.col(end - 1).isZero(0.0)) --end;
    if (end == 0) return;
    while (loads.col(first).isZero(0.0)) ++first;
    first -= first % kPanel;
    end = std::min((end + kPanel - 1) / kPanel * kPanel, loads.cols());
    if (end - first == 1) first = std::max<Index>(0, first - kPanel);
    if (count > 0) {
      first = std::min(first, begin);
      end = std::max(end, begin + count);
    }
    begin = first;
    count = end - first;
  }
};

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
    carried.noalias() = -below_.back() * transposed;
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

void Face::solve(MatrixXd& x) const {
  const Index r = modes_;
  const auto n = static_cast<Index>(ends_.size()) - 1;
  GW_EXPECTS(x.rows() == (n * kDegree + 1) * r);
  const auto node = [&](Index i) { return x.middleRows(i * r, r); };
  const auto part = [&](Index i, const LoadedColumns& c) {
    return x.block(i * r, c.begin, r, c.count);
  };
  // In each element, the loads at the inner nodes are transferred to the ends, and the
  // displacements of the inner nodes are computed for fixed ends. A column contains a load on one
  // slice and is zero in most elements. Each element therefore includes only its loaded columns.
  for (Index e = 0; e < n; ++e) {
    const Index i = e * kDegree;
    LoadedColumns here;
    here.include(x.middleRows((i + 1) * r, 2 * r));
    if (here.count == 0) continue;
    auto inner = x.block((i + 1) * r, here.begin, 2 * r, here.count);
    const MatrixXd reaction = element_->recovered.transpose() * inner;
    part(i, here) -= reaction.topRows(r);
    part(i + kDegree, here) -= reaction.bottomRows(r);
    element_->inner.solveInPlace(inner);
  }
  LoadedColumns reached;
  for (Index i = 0; i <= n; ++i) {
    if (i > 0)
      part(i * kDegree, reached).noalias() -= below_[i - 1] * part((i - 1) * kDegree, reached);
    reached.include(node(i * kDegree));
    auto here = part(i * kDegree, reached);
    factor_[i].triangularView<Eigen::Lower>().solveInPlace(here);
  }
  for (Index i = n; i >= 0; --i) {
    if (i < n) node(i * kDegree).noalias() -= below_[i].transpose() * node((i + 1) * kDegree);
    auto here = node(i * kDegree);
    factor_[i].triangularView<Eigen::Lower>().transpose().solveInPlace(here);
  }
}

MatrixXd Face::at_ends(Index e, const MatrixXd& x) const {
  MatrixXd ends(2 * modes_, x.cols());
  ends << x.middleRows(e * kDegree * modes_, modes_),
      x.middleRows((e + 1) * kDegree * modes_, modes_);
  return ends;
}

MatrixXd Face::read(const MatrixXd& weights, const MatrixXd& x) const {
  const Index r = modes_, w = weights.cols();
  MatrixXd out(node_count() * w, x.cols());
  for (Index a = 0; a < node_count(); ++a)
    out.middleRows(a * w, w).noalias() = weights.transpose() * x.middleRows(a * r, r);
  MatrixXd by_ends(2 * w, 2 * r);
  for (const Index a : {0, 1})
    by_ends.middleRows(a * w, w).noalias() =
        weights.transpose() * element_->recovered.middleRows(a * r, r);
  for (Index e = 0; e + 1 < static_cast<Index>(ends_.size()); ++e)
    out.middleRows((e * kDegree + 1) * w, 2 * w).noalias() -= by_ends * at_ends(e, x);
  return out;
}

void Face::complete(MatrixXd& x) const {
  for (Index e = 0; e + 1 < static_cast<Index>(ends_.size()); ++e)
    x.middleRows((e * kDegree + 1) * modes_, 2 * modes_).noalias() -=
        element_->recovered * at_ends(e, x);
}

}  // namespace gearwright::detail
