// Solves for displacements of a section that vary along the face as waves. [T12.6], [T12.18]
//
// The matrices of all waves have nonzero entries at the same positions, so the order of elimination
// and the positions of the entries of the factors are found once. The factors L D Lᴴ of several
// waves are computed together, which reads each index once for all of them.
//                                                theory: docs/theory/12-loaded-contact.md
#pragma once

#include <Eigen/Core>
#include <complex>
#include <span>
#include <vector>

#include "gearwright/compliance/section_matrices.hpp"

namespace gearwright::detail {

/// A wave with the wave number k, under loads with a row for each degree of freedom.
struct StripWave {
  const SectionMatrices* matrices;
  double k;
  const Eigen::MatrixXd* loads;
};

class StripSolver {
 public:
  template <class Scalar>
  using Fields = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  /// The number of waves that are solved together.
  template <class Scalar>
  static constexpr int kTogether = 4;

  /// `pattern` may be any matrices of the section, because only their pattern is used.
  StripSolver(const SectionMesh& mesh, const SectionMatrices& pattern);
  /// Returns the displacements of all degrees of freedom under the columns of the loads of each
  /// wave. The displacements of constrained nodes are 0. The function is thread-safe.
  ///
  ///   double               K(k) = aa + k (ab + abᵀ) + k² bb; u, v vary as cos kz, w as sin kz
  ///   std::complex<double> K(k) = aa + ik (ab − abᵀ) + k² bb; u, v, w vary as exp(ikz)
  ///
  /// Domain    at most kTogether waves; τ = 0 and matrices made with `wave` true if Scalar is
  ///           double, and with `wave` false otherwise; no axial loads if k = 0 and τ = 0 (contract)
  template <class Scalar>
  std::vector<Fields<Scalar>> solve(std::span<const StripWave> waves) const;

 private:
  template <class Scalar, int N>
  class Factor;
  template <class Scalar, int N>
  std::vector<Fields<Scalar>> solve_together(std::span<const StripWave> waves) const;
  void find_factor_entries();

  std::vector<int> free_;  // unconstrained degrees of freedom, in the order of elimination
  // An entry of the upper triangle of K. `at` and `mirrored` are the indices of the entry and of
  // its mirror image in the values of SectionMatrices. Entries are stored column by column.
  struct Entry {
    int row, at, mirrored;
  };
  std::vector<int> upper_begin_;  // index of the first entry of each column
  std::vector<Entry> upper_;
  // The entries of L below the diagonal. In `column_of_`, the entries of each row are in the order
  // in which the elimination uses them.
  std::vector<int> row_begin_, column_of_;    // row by row: columns
  std::vector<int> lower_begin_, lower_row_;  // column by column: rows
};

template <>
inline constexpr int StripSolver::kTogether<std::complex<double>> = 3;

}  // namespace gearwright::detail
