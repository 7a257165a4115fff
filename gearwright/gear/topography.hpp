// Describes the topography of a flank by the material removed at the points of a grid, and by the
// smooth surface through these points.
//
//   d, z   diameter and height from the middle of the face, mm         s(d, z)   removed, mm
//
// The surface is a tensor product of cubic splines with not-a-knot ends. It is twice continuously
// differentiable. Its error is of fourth order in the grid step up to the edges of the flank. The
// error of a natural spline would be of second order at the edges, because a natural spline has no
// curvature at its ends. Two or three points along a side give the line or the parabola through
// them.
//
//   Laws  (1) the surface passes through the points of the grid
//         (2) with four or more points along a side, polynomials of third degree are reproduced
//         (3) the order of the directions d and z in the computation does not change the surface
#pragma once

#include <vector>

namespace gearwright {

struct Topography {
  std::vector<double> diameters;  ///< mm, ascending, two or more
  std::vector<double> heights;    ///< z  mm, ascending, two or more
  std::vector<double> removed;    ///< mm, [i · heights.size() + j] at diameter i, height j
};

/// True if the members have the required sizes and order.
bool is_grid(const Topography& topography);

class TopographySpline {
 public:
  /// Domain    is_grid (contract)
  explicit TopographySpline(const Topography& grid);

  struct Value {
    /// Removed material s, mm; its first derivatives with respect to diameter and height z; its
    /// second derivatives.
    double s, d, z, dd, dz, zz;
  };
  /// Returns the surface at a point. Beyond the grid, the outermost cubic is continued. The
  /// function does not allocate memory.
  Value at(double diameter, double height) const;

 private:
  struct Node {
    double s, d, z, dz;
  };
  std::vector<double> diameters_, heights_;
  std::vector<Node> nodes_;
};

}  // namespace gearwright
