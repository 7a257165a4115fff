// Small dense problems of linear algebra, solved by decompositions of Eigen.
//
// These templates are the most expensive of the engine, with two to seven seconds of compilation
// each. They are instantiated once, behind these functions.
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

/// x with a·x = b, by elimination with complete pivoting. Unknowns that a singular `a` leaves free
/// are 0.
///
/// Domain    a is square, b as long (contract)
Eigen::VectorXd solve_linear(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// The x of least norm among those that minimise |a·x − b|.
///
/// Domain    b has a row for each of a (contract)
Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

}  // namespace gearwright
