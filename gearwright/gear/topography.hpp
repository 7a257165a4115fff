// A flank's topography: material removed at the points of a grid, and the smooth surface through
// them.
//
//   d, z   diameter and height from the middle of the face, mm         s(d, z)   removed, mm
//
// Tensor product of cubic splines, C2, not-a-knot at the ends. A natural spline has no curvature at
// its ends: it would take the crowning off the edges of the flank, where contact ends, and be wrong
// there by the square of the grid's step. Not-a-knot is right to its fourth power up to the edge.
// Two or three points on a side: the line or the parabola through them.
//
//   Laws  (1) the points of the grid are met      (2) cubics in d and in z are given back
//         (3) rows and columns may change places: splines along d first or along z first agree
#pragma once

#include <vector>

namespace gearwright {

struct Topography {
  std::vector<double> diameters;  ///< mm, growing, two or more
  std::vector<double> heights;    ///< z  mm, growing, two or more
  std::vector<double> removed;    ///< mm, [i heights.size() + j] at diameter i and height j
};

/// Whether sizes and order are as the members say.
bool is_grid(const Topography& topography);

class TopographySpline {
 public:
  /// Domain    is_grid (contract)
  explicit TopographySpline(const Topography& grid);

  struct Value {
    double s, d, z, dd, dz, zz;  ///< mm; derivatives by diameter and height
  };
  /// Beyond the grid its outermost cubic goes on. No allocation.
  Value at(double diameter, double height) const;

 private:
  struct Node {
    double s, d, z, dz;
  };
  std::vector<double> diameters_, heights_;
  std::vector<Node> nodes_;
};

}  // namespace gearwright
