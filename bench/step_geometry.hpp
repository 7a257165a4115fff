// Curves and surfaces of walls in the CAD kernel's terms.
//
//   slice    a layer z_low ≤ z ≤ z_high of a body; the section at z is turned by e^{iτz}
//   u, v     of a wall's surface: u counter-clockwise, v = z in mm
//
//   shape     surface                                   level edge's u, from begin to end
//   spline    B-spline, poles h_j c_i                   0 to 1
//   circle    cylinder about the axis                   π − w/2 to π + w/2, w the wall's angle
//   line      plane                                     0 to its length, mm
//
// A circle's x direction points away from the middle of its wall: u = π is in the middle and the
// seam at u = 0 is on the other side, where no wall less than a turn wide can meet it.
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <gp_Pnt.hxx>
#include <vector>

#include "gearwright/cad/walls.hpp"

namespace gearwright {

/// A plane z = const that bounds a slice.
struct StepLevel {
  double z;
  double angle;  ///< τz  rad
  Complex turn;  ///< e^{iτz}
};

struct StepSlice {
  StepLevel low;
  StepLevel high;
  double middle_angle;         ///< rad, halfway between the two levels'
  std::vector<Complex> helix;  ///< h_j, the ends equal to the levels' turns to the last bit
  std::vector<double> height;  ///< z of the poles, mm
  WallKnots knots;             ///< in v = z

  bool straight() const { return low.angle == high.angle; }
};

std::vector<StepLevel> levels_of(const WallLoop& loop, double face_width);
StepSlice slice_between(const StepLevel& low, const StepLevel& high, const HelixSpline& helix);

struct StepRange {
  double first;
  double last;
};

gp_Pnt point_at(Complex section_point, const StepLevel& level);

/// u of a wall's begin and end.
StepRange u_range(const Wall& wall);

/// The wall's section in a level, with the parameter u.
Handle(Geom_Curve) level_curve(const Wall& wall, const StepLevel& level);

/// The path of a section point through a slice, with the parameter z.
Handle(Geom_Curve) upright_curve(Complex section_point, const StepSlice& slice);

Handle(Geom_Surface) wall_surface(const Wall& wall, const StepSlice& slice);

/// A wall's edges in the (u, v) of its surface; null on planes, which need none.
Handle(Geom2d_Curve) level_trace(const Wall& wall, const StepSlice& slice, const StepLevel& level);
Handle(Geom2d_Curve) upright_trace(const Wall& wall, const StepSlice& slice, double u);

}  // namespace gearwright
