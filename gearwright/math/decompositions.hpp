// Small dense problems of linear algebra, solved by decompositions of Eigen.
//
// Each of these templates of Eigen takes two to seven seconds to compile, longer than anything else
// in the engine. The templates are therefore instantiated only once, in decompositions.cpp.
#pragma once

#include <Eigen/Core>

namespace gearwright {

/// A symmetric 2×2 matrix as V diag(values) Vᵀ.
struct SymmetricEigen {
  Eigen::Vector2d values;   ///< eigenvalues, ascending
  Eigen::Matrix2d vectors;  ///< V, a unit eigenvector in each column, in the order of `values`
};

/// Eigenvalues and eigenvectors of m. Only the lower triangle of m is read.
SymmetricEigen symmetric_eigen(const Eigen::Matrix2d& m);

/// The solution x of a·x = b, by elimination with complete pivoting. If `a` is singular, the
/// unknowns that the equations do not determine are 0.
///
/// Domain    a is square, and b has as many rows as a (contract)
Eigen::VectorXd solve_linear(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// The x that minimises |a·x − b|. If several x minimise it, the result is the x of least norm.
///
/// Domain    b has as many rows as a (contract)
Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

}  // namespace gearwright
