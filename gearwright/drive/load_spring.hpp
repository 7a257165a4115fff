// A mesh as a spring in one position: the force along the line of action over the approach of its
// teeth.
//
//   δ      approach from the first touch, mm      F   force along the transverse line of action, N
//   F(δ)   0 for δ ≤ 0; through the nodes with their slopes, rising and smooth [T13.24]
//                                              theory: docs/theory/13-drives.md
//
// Internal to drive/.
#pragma once

#include <vector>

namespace gearwright::detail {

/// A solved load: approach, force, and slope dF/dδ there.
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

  /// F = k δ.
  static LoadSpring linear(double stiffness);
  /// The spring through the nodes, in any order. Nodes that do not rise above the one before are
  /// left out.
  ///
  /// Formula   cubic Hermite pieces, their slopes limited to three times the secants (Fritsch and
  ///           Carlson 1980), so F rises everywhere; below the first node the parabola with its
  ///           slope; above the last one its tangent; [T13.24]
  /// Laws      exact at the nodes; a linear spring from nodes of a line is that line
  /// Domain    a node with approach, force and slope > 0 (contract)
  explicit LoadSpring(std::vector<SpringNode> nodes);

  Value at(double approach) const;
  /// The approach under a force ≥ 0, the inverse of at().
  double approach(double force) const;

 private:
  std::vector<SpringNode> nodes_;  // from (0, 0)
};

}  // namespace gearwright::detail
