// Computes the amplitudes f(z) of the modes by one-dimensional finite elements of third order.
//
//   K = m00 ⊗ K_aa + m01 ⊗ K_ab + m01ᵀ ⊗ K_abᵀ + m11 ⊗ K_bb                          [T12.8]
//   m00 = ∫NNᵀ, m01 = ∫N N′ᵀ, m11 = ∫N′N′ᵀ of an element with the shape functions N
//
// The two inner nodes of each element are eliminated first, which leaves a block-tridiagonal
// system for the ends of the elements. All elements have the same length, so this elimination is
// done once.
//
//   u_i = K_ii⁻¹ f_i − K_ii⁻¹ K_ie u_e        f_e − (K_ii⁻¹ K_ie)ᵀ f_i  acts on the ends  [T12.8a]
//
// A load along the face is a product: a load on the modes times a function of z. K_ii⁻¹ is
// therefore applied once to each load on the modes, and not to each function of z. Both end faces
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
  static constexpr int kDegree = 3;
  /// Divides the face from −width/2 to width/2 into elements of about the length `element`. All
  /// lengths are in modules.
  Face(const ModeMatrices& modes, double width, double element);
  ~Face();

  int element_count() const { return static_cast<int>(ends_.size()) - 1; }
  int node_count() const { return static_cast<int>(nodes_.size()); }
  int mode_count() const { return modes_; }
  /// Returns the weights with which the nodal values add up to the value at z.
  Eigen::VectorXd at(double z) const;
  /// Returns the weights with which the nodal values add up to the slope at z.
  Eigen::VectorXd slope_at(double z) const;
  /// Returns the weights with which the nodal values add up to the mean over [lo, hi].
  Eigen::VectorXd mean(double lo, double hi) const;

  /// Loads on the modes, and their effects if they act at an inner node of an element. There is a
  /// row for each mode and a column for each load.
  struct Loads {
    Eigen::MatrixXd at_node;
    /// For each inner node, the loads on the two ends that replace a load at this node.
    std::array<Eigen::MatrixXd, 2> at_ends;
    /// For each inner node, the amplitudes at both inner nodes under a load at this node, if the
    /// ends are fixed.
    std::array<Eigen::MatrixXd, 2> inner;
  };
  Loads loads(const Eigen::MatrixXd& on_modes) const;
  /// Returns the amplitudes at the ends of the elements under column `load` of `loads`. Each column
  /// of `along` distributes the load over the nodes. It takes less time if the columns are ordered
  /// by the position of the load along the face. A column of the result lists all modes at the
  /// first end, then all modes at the second end, and so on.
  Eigen::MatrixXd solve(const Loads& loads, int load, const Eigen::MatrixXd& along) const;
  /// K_ii⁻¹ K_ie, which has 2r rows and 2r columns for r modes.
  const Eigen::MatrixXd& recovered() const;

 private:
  struct Element;
  Eigen::VectorXd shape(double z, bool slope) const;

  std::vector<double> ends_, nodes_;
  std::unique_ptr<const Element> element_;
  std::vector<Eigen::MatrixXd> factor_, below_;  // Cholesky factors of the block-tridiagonal matrix
  int modes_ = 0;
};

}  // namespace gearwright::detail
