// The layers of a body between its end faces: where its walls are cut across, and how a point of the
// section climbs through one of them. Internal to cad/.
//
//   level    a plane z = const; the section in it is turned by e^{iτz}
//   slice    the layer between two levels; its helix is that of the body, turned to the slice's middle
//
// A pole of a wall in a slice is h_j c_i at the height z_j: h_j and z_j are the slice's, c_i the wall's.
#pragma once

#include <vector>

#include "gearwright/cad/walls.hpp"

namespace gearwright {

struct WallLevel {
  double z;      ///< mm
  double angle;  ///< τz  rad
  Complex turn;  ///< e^{iτz}
};

struct WallSlice {
  WallLevel low;
  WallLevel high;
  double middle_angle;         ///< rad, halfway between the two levels'
  std::vector<Complex> helix;  ///< h_j, the ends equal to the levels' turns to the last bit
  std::vector<double> height;  ///< z_j  mm
  WallKnots knots;             ///< in z, mm

  bool straight() const { return low.angle == high.angle; }
};

/// From the bottom, z = −b/2, to the top, z = b/2.
std::vector<WallLevel> levels_of(const WallLoop& loop, double face_width);

WallSlice slice_between(const WallLevel& low, const WallLevel& high, const HelixSpline& helix);

Vec3 point_at(Complex section_point, const WallLevel& level);

/// The path of a section point: its pole j, 0 ≤ j < helix.size().
Vec3 climbing_pole(Complex section_point, const WallSlice& slice, std::size_t j);

}  // namespace gearwright
