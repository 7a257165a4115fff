// Writes a toothed body as an advanced B-rep of a STEP file. Internal to cad/.
//
//   u, v   parameters of the face of a wall: u runs counter-clockwise about the axis, v upwards
//   h_j c_i   poles of a wall, see cad/walls.hpp
//
//   shape     surface                            edges in a plane z = const
//   spline    B-spline, poles h_j c_i            B-spline
//   circle    cylinder about the axis            circle
//   line      plane                              line
//
// Edges along the teeth are lines, or B-splines that follow the helix. Every vertex, edge and pole
// is written once: the boundary poles of a face are identical to those of its edges and of the
// neighbouring faces. An edge lies exactly on its faces, except that a helix spline deviates from a
// true cylinder by less than kHelixTarget_mm. The x direction of each circle points away from the
// middle of its wall. Walls that span less than a full turn therefore never cross the seam at u =
// 0.
//
// A double-helical gear has two stacks of walls, one for each hand of helix, either adjacent or
// separated by a groove.
//
//   Law   every edge is used twice, once in each direction
#pragma once

#include <cstddef>

#include "gearwright/cad/modified_fit.hpp"
#include "gearwright/cad/modified_teeth.hpp"
#include "gearwright/cad/part21.hpp"
#include "gearwright/cad/walls.hpp"

namespace gearwright {

/// Distance within which points, edges and faces of a solid agree, mm. The file states this value
/// as its uncertainty.
inline constexpr double kBrepUncertainty_mm = 1e-7;
static_assert(kHelixTarget_mm <= kBrepUncertainty_mm / 2);

struct Brep {
  Part21Id solid;  ///< a MANIFOLD_SOLID_BREP whose normals point outwards
  std::size_t face_count;
  std::size_t edge_count;  ///< number of edges; each shared edge counts once
};

/// Writes the solid of a body in its own frame. The pose is not applied.
///
/// Units     mm
/// Domain    walls = make_walls(body); an internal gear has a rim (contract)
/// Cost      proportional to the number of walls
Brep add_brep(Part21& out, const ToothedBody& body, const BodyWalls& walls);

// Writes a rack as an advanced B-rep of a STEP file.
//
//   part of the tooth   surface                                edges on the border
//   land, flank         plane                                  lines
//   fillet              cylinder along the tooth, radius ρ_f   ellipses (circles for a spur rack)
//
// All surfaces and edges are exact. Every face of the teeth is a strip of the plan view
// (cad/rack_plan.hpp). A strip usually has four edges, one with a corner of the bar has five, and
// one with two corners has six.
//
//   Law   every edge is used twice, once in each direction

/// Returns the number of faces: the strips, and five planes for the back, the two ends and the two
/// sides.
std::size_t rack_face_count(const ToothedBody& body);

/// Writes the solid of a rack in its own frame. The pose is not applied.
///
/// Units     mm
/// Domain    a body that is a rack (contract)
Brep add_rack_brep(Part21& out, const ToothedBody& body);

// Writes teeth with flank modifications as an advanced B-rep of a STEP file.
//
//   level   a plane z = const, or the line of a flank at which an end relief begins
//   layer   the part of the teeth between two levels
//   slice   the part of the teeth between two planes; it may contain several layers
//
// Flanks and fillets have one B-spline face per arc and layer (cad/modified_fit.hpp). Lands are
// true cylinders with one face per slice, whose upright sides consist of one edge per layer.
// An edge on a land deviates from the cylinder by at most kHelixTarget_mm.
//
//   Law   every edge is used twice, once in each direction

/// Writes the solid of a body with the given modified teeth, in its own frame.
///
/// Units     mm
/// Domain    walls = make_walls(body), fit = fit_modified(teeth, …) (contract)
Brep add_modified_brep(Part21& out, const ToothedBody& body, const BodyWalls& walls,
                       const ModifiedTeeth& teeth, const ModifiedFit& fit);

}  // namespace gearwright
