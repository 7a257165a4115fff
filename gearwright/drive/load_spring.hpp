// Describes a mesh in one position as a spring: the force along the line of action as a function of
// the approach of the teeth.
//
//   δ      approach from the first touch, mm      F   force along the transverse line of action, N
//   F(δ)   0 for δ ≤ 0, then a smooth rising curve through the nodes with their slopes [T13.24]
//                                              theory: docs/theory/13-drives.md
#pragma once

#include <vector>

namespace gearwright::detail {

/// A load at which the contact was solved: approach, force, and slope dF/dδ.
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

  /// The spring with F = k δ.
  static LoadSpring linear(double stiffness);
  /// The spring through the nodes. They may be given in any order and are sorted. A node is left
  /// out if its force or its approach does not exceed the value at the node before it.
  ///
  /// Formula   cubic Hermite pieces, their slopes limited to three times the secants (Fritsch and
  ///           Carlson 1980), so F rises everywhere; below the first node, the parabola with the
  ///           slope of that node; above the last node, the tangent at that node; [T13.24]
  /// Laws      exact at the nodes; if the nodes are on a line through 0, the spring is this line
  /// Domain    a node with approach, force and slope > 0 (contract)
  explicit LoadSpring(std::vector<SpringNode> nodes);

  Value at(double approach) const;
  /// The approach under a force ≥ 0, the inverse of at().
  double approach(double force) const;

 private:
  std::vector<SpringNode> nodes_;  // beginning with (0, 0)
};

}  // namespace gearwright::detail
