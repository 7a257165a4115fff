// Writes a toothed body as an advanced B-rep of a STEP file. Internal to cad/.
//
//   u, v   parameters of a wall's face: u counter-clockwise about the axis, v upwards
//
//   shape     surface                            edges in a level
//   spline    B-spline, poles h_j c_i            B-spline
//   circle    cylinder about the axis            circle
//   line      plane                              line
//
// Upright edges are lines, or B-splines that climb with the helix. Every vertex, edge and pole is
// written once: the boundary poles of a face are identical to the points of its edges and of its
// neighbours. The only deviation is that of the helix spline from a true cylinder, which is less
// than kHelixTarget_mm. A circle's x direction points away from the middle of its wall, so no wall
// of less than a turn meets the seam at u = 0.
//
// A double-helical gear is two such stacks of walls, one on the other or with a groove between them.
//
//   Law   every edge is used twice, once in each direction
#pragma once

#include <cstddef>

#include "gearwright/cad/part21.hpp"
#include "gearwright/cad/walls.hpp"

namespace gearwright {

/// Distance within which points, edges and faces of a solid agree, mm. The file states it as its
/// uncertainty.
inline constexpr double kBrepUncertainty_mm = 1e-7;
static_assert(kHelixTarget_mm <= kBrepUncertainty_mm / 2);

struct Brep {
  Part21Id solid;  ///< a MANIFOLD_SOLID_BREP, with normals pointing out
  std::size_t face_count;
  std::size_t edge_count;  ///< each shared edge counts once
};

/// Writes the solid of a body in its own frame (the pose is not applied).
///
/// Units     mm
/// Domain    walls = make_walls(body) (contract); an internal gear has its rim
/// Cost      proportional to the number of walls
Brep add_brep(Part21& out, const ToothedBody& body, const BodyWalls& walls);

}  // namespace gearwright
