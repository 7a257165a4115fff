// Small dense problems of linear algebra, answered by Eigen's decompositions.
//
// Those templates are the dearest of the engine: two to seven seconds of compilation each. They
// stand here once, and what needs an answer does not see them.
#pragma once

#include <Eigen/Core>

namespace gearwright {

/// A symmetric 2×2 matrix as V diag(values) Vᵀ.
struct SymmetricEigen {
  Eigen::Vector2d values;   ///< ascending
  Eigen::Matrix2d vectors;  ///< of length 1, in columns, in the order of the values
};

/// Reads the lower triangle only.
SymmetricEigen symmetric_eigen(const Eigen::Matrix2d& m);

/// x with a·x = b, by elimination with complete pivoting. What a singular `a` leaves free is 0.
///
/// Domain    a is square, b as long (contract)
Eigen::VectorXd solve_linear(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// The shortest of the x that make |a·x − b| least.
///
/// Domain    b has a row for each of a (contract)
Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

}  // namespace gearwright
