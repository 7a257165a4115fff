// Sparse stiffness matrices of a section, for displacements that vary along the face as waves
// or in any other way.
//
//   U = (u, v, w)   displacement in coordinates that turn with the helix; dof 3·node + component
//   A, B            matrices that give the strains due to U and due to ∂U/∂z   [T12.5]
//   τ               rotation of the section per length, 1/m_n; 0 for a spur gear
//   E = 1, lengths in normal modules                theory: docs/theory/12-loaded-contact.md
#pragma once

#include <Eigen/SparseCore>

#include "gearwright/compliance/q9.hpp"
#include "gearwright/compliance/section_mesh.hpp"

namespace gearwright::detail {

using Sparse = Eigen::SparseMatrix<double>;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Returns the matrix of Hooke's law, for strains xx, yy, zz, xy, yz, zx.   Domain: 0 ≤ ν < ½
/// (contract)
Matrix6 hooke(double youngs_modulus, double poisson_ratio);

/// A and B for the 27 degrees of freedom of an element at the point `at`. [T12.4], [T12.5]
struct StrainPair {
  Eigen::Matrix<double, 6, 27> a, b;
};
StrainPair element_strains(const Node9& value, const Slope9& slope, const Eigen::RowVector2d& at,
                           double tau, double shear_sign);

struct SectionMatrices {
  Sparse aa, ab, bb;  ///< ∫AᵀDA, ∫AᵀDB, ∫BᵀDB over the section; ab is not symmetric
};

/// Computes the matrices of a section. If `wave` is true, the product k B gives the strains due to
/// ∂U/∂z of the waves U = (u cos kz, v cos kz, w sin kz) [T12.6]. If `wave` is false, B gives the
/// strains due to ∂U/∂z of displacements that are arbitrary functions of z.
SectionMatrices section_matrices(const SectionMesh& mesh, const Matrix6& law, double tau,
                                 bool wave);

/// Returns the sum ε_x + ε_y of the in-plane strains of each displacement field. At each node, the
/// sum is averaged over the elements and stored as the component w of the node. At the bore, it is
/// set to 0.
Eigen::MatrixXd trace_fields(const SectionMesh& mesh, const Eigen::MatrixXd& fields);

}  // namespace gearwright::detail
