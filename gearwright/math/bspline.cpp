#include "gearwright/math/bspline.hpp"

#include <algorithm>
#include <utility>

#include "gearwright/base/contract.hpp"

namespace gearwright {
namespace {

// The knots are p + 1 zeros, the inner knots i/(n − p), and p + 1 ones.
std::vector<double> uniform_knots(int degree, int poles) {
  GW_EXPECTS(degree >= 1);
  GW_EXPECTS(poles >= degree + 1);
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
  const int pieces = poles - degree;
  for (int i = 1; i < pieces; ++i) knots.push_back(static_cast<double>(i) / pieces);
  knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, 1.0);
  return knots;
}

}  // namespace

BSplineBasis::BSplineBasis(int degree, int poles)
    : degree_(degree), poles_(poles), knots_(uniform_knots(degree, poles)) {
  prepare();
}

BSplineBasis::BSplineBasis(int degree, std::vector<double> knots)
    : degree_(degree),
      poles_(static_cast<int>(knots.size()) - degree - 1),
      knots_(std::move(knots)) {
  GW_EXPECTS(degree_ >= 1);
  GW_EXPECTS(poles_ >= degree_ + 1);
  GW_EXPECTS(std::is_sorted(knots_.begin(), knots_.end()));
  const std::vector<int> m = multiplicities();
  GW_EXPECTS(m.size() >= 2 && m.front() == degree_ + 1 && m.back() == degree_ + 1);
  GW_EXPECTS(std::all_of(m.begin() + 1, m.end() - 1, [&](int k) { return k <= degree_; }));
  prepare();
}

std::vector<double> BSplineBasis::distinct_knots() const {
  std::vector<double> result = knots_;
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::vector<int> BSplineBasis::multiplicities() const {
  std::vector<int> result;
  for (std::size_t i = 0; i < knots_.size(); ++i) {
    if (i == 0 || knots_[i] != knots_[i - 1]) {
      result.push_back(1);
    } else {
      ++result.back();
    }
  }
  return result;
}

int BSplineBasis::span(double u) const {
  GW_EXPECTS(u >= knots_.front() && u <= knots_.back());
  // The index of the last knot ≤ u among t_p … t_(n−1). If u is the right end, this knot is the
  // start of the last span that is not empty.
  const auto first = knots_.begin() + degree_;
  const auto last = knots_.begin() + poles_;
  const auto above = std::upper_bound(first, last, u);
  return static_cast<int>(above - knots_.begin()) - 1;
}

// The Cox-de Boor recursion without divisions by empty spans (The NURBS Book, algorithm A2.2).
BSplineBasis::Local BSplineBasis::local(double u) const {
  const auto p = static_cast<std::size_t>(degree_);
  const int s = span(u);
  const auto at = static_cast<std::size_t>(s);
  std::vector<double> values(p + 1, 0.0);
  values[0] = 1.0;
  for (std::size_t j = 1; j <= p; ++j) {
    double saved = 0.0;
    for (std::size_t r = 0; r < j; ++r) {
      const double right = knots_[at + r + 1] - u;
      const double left = u - knots_[at + 1 + r - j];
      const double term = values[r] / (right + left);
      values[r] = saved + right * term;
      saved = left * term;
    }
    values[j] = saved;
  }
  return {s - degree_, std::move(values)};
}

void BSplineBasis::prepare() {
  const auto p = static_cast<std::size_t>(degree_);
  greville_.reserve(static_cast<std::size_t>(poles_));
  for (std::size_t i = 0; i < static_cast<std::size_t>(poles_); ++i) {
    double sum = 0.0;
    for (std::size_t j = 1; j <= p; ++j) sum += knots_[i + j];
    greville_.push_back(sum / degree_);
  }
  // At an end, p equal knots are averaged. The computed mean may differ from the knot by rounding,
  // so the ends are set exactly.
  greville_.front() = knots_.front();
  greville_.back() = knots_.back();

  factors_ = Eigen::MatrixXd::Zero(poles_, poles_);
  for (int i = 0; i < poles_; ++i) {
    const Local row = local(greville_[static_cast<std::size_t>(i)]);
    for (int j = 0; j <= degree_; ++j) {
      factors_(i, row.first + j) = row.values[static_cast<std::size_t>(j)];
    }
  }
  for (int k = 0; k < poles_; ++k) {
    const int end = std::min(poles_, k + degree_ + 1);
    for (int i = k + 1; i < end; ++i) {
      if (factors_(i, k) == 0.0) continue;
      const double factor = factors_(i, k) / factors_(k, k);
      factors_(i, k) = factor;
      for (int j = k + 1; j < end; ++j) factors_(i, j) -= factor * factors_(k, j);
    }
  }
}

Eigen::MatrixXd BSplineBasis::interpolate(const Eigen::MatrixXd& samples) const {
  GW_EXPECTS(samples.rows() == poles_);
  Eigen::MatrixXd x = samples;
  for (int i = 0; i < poles_; ++i) {
    for (int k = std::max(0, i - degree_); k < i; ++k) {
      if (factors_(i, k) != 0.0) x.row(i) -= factors_(i, k) * x.row(k);
    }
  }
  for (int i = poles_ - 1; i >= 0; --i) {
    for (int j = i + 1; j < std::min(poles_, i + degree_ + 1); ++j) {
      if (factors_(i, j) != 0.0) x.row(i) -= factors_(i, j) * x.row(j);
    }
    x.row(i) /= factors_(i, i);
  }
  return x;
}

Eigen::VectorXd BSplineBasis::evaluate(const Eigen::MatrixXd& poles, double u) const {
  GW_EXPECTS(poles.rows() == poles_);
  const Local here = local(u);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(poles.cols());
  for (int j = 0; j <= degree_; ++j) {
    result += here.values[static_cast<std::size_t>(j)] * poles.row(here.first + j).transpose();
  }
  return result;
}

Eigen::VectorXd BSplineBasis::derivative(const Eigen::MatrixXd& poles, double u, int k) const {
  GW_EXPECTS(poles.rows() == poles_);
  GW_EXPECTS(k >= 0);
  if (k > degree_) return Eigen::VectorXd::Zero(poles.cols());
  // The formula D_i = (p − l)(P_(i+1) − P_i)/(t_(i+p+1) − t_(i+1+l)), applied for l = 0 … k − 1,
  // gives the local poles of the derivative. De Boor's triangle of the lower degree then evaluates
  // these poles on the same span.
  const int s = span(u);
  Eigen::MatrixXd d = poles.middleRows(s - degree_, degree_ + 1);
  const auto knot = [&](int i) { return knots_[static_cast<std::size_t>(i)]; };
  for (int l = 0; l < k; ++l) {
    const int q = degree_ - l;
    for (int i = 0; i < q; ++i) {
      const double width = knot(s + 1 + i) - knot(s + 1 + i - q);
      d.row(i) = (d.row(i + 1) - d.row(i)) * (q / width);
    }
  }
  const int q = degree_ - k;
  for (int level = 1; level <= q; ++level) {
    for (int i = 0; i <= q - level; ++i) {
      const double from = knot(s + level + i - q);
      const double w = (u - from) / (knot(s + 1 + i) - from);
      d.row(i) = (1.0 - w) * d.row(i) + w * d.row(i + 1);
    }
  }
  return d.row(0).transpose();
}

}  // namespace gearwright
