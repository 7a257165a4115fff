// Computes the amplitudes f(z) of the modes by one-dimensional finite elements of third order.
//
//   K = m00 ⊗ K_aa + m01 ⊗ K_ab + m01ᵀ ⊗ K_abᵀ + m11 ⊗ K_bb                          [T12.8]
//   m00 = ∫NNᵀ, m01 = ∫N N′ᵀ, m11 = ∫N′N′ᵀ of an element with the shape functions N
//
// The two inner nodes of each element are eliminated first, which leaves a block-tridiagonal
// system. All elements have the same length, so this elimination is done once. Both end faces
// z = const are unconstrained.
//                                                theory: docs/theory/12-loaded-contact.md
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

#include "gearwright/compliance/section_modes.hpp"

namespace gearwright::detail {

class Face {
 public:
  /// Divides the face from −width/2 to width/2 into elements of about the length `element`. All
  /// lengths are in modules.
  Face(const ModeMatrices& modes, double width, double element);
  ~Face();

  int node_count() const { return static_cast<int>(nodes_.size()); }
  int mode_count() const { return modes_; }
  /// Returns the weights with which the nodal values add up to the value at z.
  Eigen::VectorXd at(double z) const;
  /// Returns the weights with which the nodal values add up to the slope at z.
  Eigen::VectorXd slope_at(double z) const;
  /// Returns the weights with which the nodal values add up to the mean over [lo, hi].
  Eigen::VectorXd mean(double lo, double hi) const;
  /// Replaces the load in each column by the amplitudes under this load. A column lists all modes
  /// at the first node, then all modes at the second node, and so on. In the result, the amplitudes
  /// at the inner nodes of an element do not yet contain the effect of the amplitudes at its ends.
  void solve(Eigen::MatrixXd& columns) const;
  /// Returns `weights`ᵀ times the amplitudes at each node, including the effect that is missing at
  /// the inner nodes. `columns` is a result of solve().
  Eigen::MatrixXd read(const Eigen::MatrixXd& weights, const Eigen::MatrixXd& columns) const;
  /// Adds the effect that is missing at the inner nodes to a result of solve().
  void complete(Eigen::MatrixXd& columns) const;

 private:
  struct Element;
  Eigen::VectorXd shape(double z, bool slope) const;
  Eigen::MatrixXd at_ends(Eigen::Index element, const Eigen::MatrixXd& columns) const;

  std::vector<double> ends_, nodes_;
  std::unique_ptr<const Element> element_;
  std::vector<Eigen::MatrixXd> factor_, below_;  // Cholesky factors of the block-tridiagonal matrix
  int modes_ = 0;
};

}  // namespace gearwright::detail
