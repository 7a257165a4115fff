// A flank's topography: material removed at the points of a grid, and the smooth surface through
// them.
//
//   d, z   diameter and height from the middle of the face, mm         s(d, z)   removed, mm
//
// Tensor product of cubic splines, C2, not-a-knot at the ends. A natural spline has no curvature at
// its ends, so it would remove the crowning at the edges of the flank, where contact ends, with an
// error of second order in the grid step. The not-a-knot spline has an error of fourth order up to
// the edge. Two or three points on a side give the line or the parabola through them.
//
//   Laws  (1) the surface passes through the points of the grid
//         (2) cubics in d and in z are reproduced
//         (3) rows and columns may be exchanged: splines along d first or along z first agree
#pragma once

#include <vector>

namespace gearwright {

struct Topography {
  std::vector<double> diameters;  ///< mm, growing, two or more
  std::vector<double> heights;    ///< z  mm, growing, two or more
  std::vector<double> removed;    ///< mm, [i heights.size() + j] at diameter i and height j
};

/// True if sizes and order satisfy the conditions of the members.
bool is_grid(const Topography& topography);

class TopographySpline {
 public:
  /// Domain    is_grid (contract)
  explicit TopographySpline(const Topography& grid);

  struct Value {
    double s, d, z, dd, dz, zz;  ///< mm; derivatives by diameter and height
  };
  /// Beyond the grid the outermost cubic continues. The function does not allocate.
  Value at(double diameter, double height) const;

 private:
  struct Node {
    double s, d, z, dz;
  };
  std::vector<double> diameters_, heights_;
  std::vector<Node> nodes_;
};

}  // namespace gearwright
