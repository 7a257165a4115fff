// Clamped B-splines and their interpolation at the Greville abscissae.
//
//   p      degree                          n     number of poles, n ≥ p + 1
//   t_j    knots, n + p + 1 of them: p + 1 equal knots at each end, non-decreasing in between
//   N_i    basis functions, i = 0 … n−1, nonzero on [t_i, t_(i+p+1)]; their sum is 1 at every u
//   g_i    Greville abscissae (t_(i+1) + … + t_(i+p)) / p; with P_i = g_i, C(u) = u
//   P_i    poles, rows of an n × dim matrix;  C(u) = Σ N_i(u) P_i
//
// Interpolation at g_i is well posed (Schoenberg-Whitney: N_i(g_i) > 0). The collocation matrix
// A_ij = N_j(g_i) is banded and totally positive. Elimination without pivoting is therefore
// backward stable and causes no fill-in (de Boor, A Practical Guide to Splines, ch. XIII).
//
//   Laws  (1) the first and the last pole are equal to the first and the last sample, bit for bit
//         (2) polynomials of degree ≤ p are reproduced
//         (3) if the knots are symmetric, the poles in reverse order give the same curve in the
//             opposite direction
#pragma once

#include <Eigen/Core>
#include <vector>

namespace gearwright {

class BSplineBasis {
 public:
  /// Basis with uniform knots on [0, 1].
  /// Domain    degree ≥ 1, poles ≥ degree + 1 (contract)
  BSplineBasis(int degree, int poles);

  /// Basis with the given knots, which are clamped at both ends. An inner knot occurs at most
  /// `degree` times.
  /// Domain    knots are non-decreasing, and each end knot occurs degree + 1 times (contract)
  BSplineBasis(int degree, std::vector<double> knots);

  int degree() const { return degree_; }
  int poles() const { return poles_; }

  /// The full knot vector of poles + degree + 1 numbers, in which each knot occurs as often as its
  /// multiplicity.
  const std::vector<double>& knots() const { return knots_; }

  /// The distinct knots in increasing order, and the multiplicity of each knot, as OCCT needs them.
  std::vector<double> distinct_knots() const;
  std::vector<int> multiplicities() const;

  /// The Greville abscissae g_i. The first and the last are exactly the ends of the knot vector.
  const std::vector<double>& greville() const { return greville_; }

  /// Poles of the spline that passes through row i of `samples` at u = g_i.
  ///
  /// Units     as the samples
  /// Domain    samples.rows() == poles() (contract); any number of columns
  /// Accuracy  backward stable; the columns do not influence each other
  Eigen::MatrixXd interpolate(const Eigen::MatrixXd& samples) const;

  /// C(u) for poles in rows.   Domain: knots.front() ≤ u ≤ knots.back() (contract)
  Eigen::VectorXd evaluate(const Eigen::MatrixXd& poles, double u) const;

  /// dᵏC/duᵏ, which is zero for k > degree. At a knot, this is the derivative from the right, but
  /// at the last knot, it is the derivative from the left.
  Eigen::VectorXd derivative(const Eigen::MatrixXd& poles, double u, int k = 1) const;

  /// The p + 1 nonzero basis functions at u; values[j] belongs to pole first + j.
  struct Local {
    int first;
    std::vector<double> values;
  };
  Local local(double u) const;

 private:
  void prepare();
  int span(double u) const;

  int degree_;
  int poles_;
  std::vector<double> knots_;
  std::vector<double> greville_;
  Eigen::MatrixXd factors_;  ///< A = L U in one banded matrix; L has ones on its diagonal
};

}  // namespace gearwright
