// A tooth along its face: mode amplitudes f(z) by elements of third order between free end faces.
//
//   K = m00 ⊗ K_aa + m01 ⊗ K_ab + m01ᵀ ⊗ K_abᵀ + m11 ⊗ K_bb                          [T12.8]
//   m00 = ∫NNᵀ, m01 = ∫N N′ᵀ, m11 = ∫N′N′ᵀ of an element
//
// The two inner nodes of an element are eliminated first, which leaves a chain of blocks. Elements
// of one length share that work. The ends are free faces z = const without conditions.
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
  /// The face from −width/2 to width/2, in elements about as long as `element`, modules.
  Face(const ModeMatrices& modes, double width, double element);
  ~Face();
  Face(Face&&) noexcept;

  int node_count() const { return static_cast<int>(nodes_.size()); }
  int mode_count() const { return modes_; }
  /// Weights of the nodes: the value at z, its slope, the mean over [lo, hi].
  Eigen::VectorXd at(double z) const;
  Eigen::VectorXd slope_at(double z) const;
  Eigen::VectorXd mean(double lo, double hi) const;

  /// Replaces each column by the amplitudes under it: node after node, all modes of each.
  void solve(Eigen::MatrixXd& columns) const;

 private:
  struct Kind;
  Eigen::VectorXd shape(double z, bool slope) const;

  std::vector<double> ends_, nodes_;
  std::vector<int> kind_of_;
  std::vector<std::unique_ptr<Kind>> kinds_;
  std::vector<Eigen::MatrixXd> factor_, below_;  // of the chain
  int modes_ = 0;
};

}  // namespace gearwright::detail
