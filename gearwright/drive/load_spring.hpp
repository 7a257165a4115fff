// Describes a mesh in one position as a spring. The force of the spring along the line of action is
// a function of the approach of the teeth.
//
//   δ      approach from the first touch, mm      F   force along the transverse line of action, N
//   F(δ)   0 for δ ≤ 0, then a smooth rising curve through the nodes with their slopes [T13.24]
//                                              theory: docs/theory/13-drives.md
#pragma once

#include <vector>

namespace gearwright::detail {

/// A load for which the contact was solved, with its approach, force, and slope dF/dδ.
struct SpringNode {
  double approach;  ///< mm
  double force;     ///< N
  double slope;     ///< N/mm
};

class LoadSpring {
 public:
  struct Value {
    double force = 0.0, slope = 0.0;
  };

  /// Returns the spring with F = k δ.
  static LoadSpring linear(double stiffness);
  /// Makes the spring through the nodes, which may be given in any order. If the force or the
  /// approach of a node does not exceed the value at the node before it, this node is omitted.
  ///
  /// Formula   F consists of cubic Hermite pieces. Their slopes are limited to three times the
  ///           secants (Fritsch and Carlson 1980), so that F rises everywhere. Below the first
  ///           node, F is a parabola. Above the last node, F is the tangent; [T13.24]
  /// Laws      exact at the nodes; if the nodes are on a line through 0, the spring is this line
  /// Domain    a node with approach, force and slope > 0 (contract)
  explicit LoadSpring(std::vector<SpringNode> nodes);

  Value at(double approach) const;
  /// Returns the approach under a force ≥ 0. This is the inverse of at().
  double approach(double force) const;

 private:
  std::vector<SpringNode> nodes_;  // beginning with (0, 0)
};

}  // namespace gearwright::detail
