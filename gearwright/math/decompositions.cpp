#include "gearwright/math/decompositions.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

#include "gearwright/base/contract.hpp"

namespace gearwright {

SymmetricEigen symmetric_eigen(const Eigen::Matrix2d& m) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(m);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXd solve_linear(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  GW_EXPECTS(a.rows() == a.cols() && a.rows() == b.size());
  return a.fullPivLu().solve(b);
}

Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  GW_EXPECTS(a.rows() == b.size());
  return a.completeOrthogonalDecomposition().solve(b);
}

}  // namespace gearwright
