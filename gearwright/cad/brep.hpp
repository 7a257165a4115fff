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
// Every vertex, edge and pole is written once. The boundary poles of a face are also the poles of
// its edges and of the neighbouring faces. Edges along the teeth are lines, or B-splines that
// follow the helix. With one exception, every edge lies exactly on its faces: if a spline follows
// the helix on a true cylinder, it deviates from the cylinder by at most kHelixTarget_mm.
//
// A double-helical gear has two stacks of walls, one for each hand of helix. The stacks are
// adjacent, or a groove separates them. A solid with several gears has a stack for each gear. Plain
// cylinders, the necks, separate these stacks.
//
//   Law   every edge is used twice, once in each direction
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "gearwright/cad/modified_fit.hpp"
#include "gearwright/cad/modified_teeth.hpp"
#include "gearwright/cad/part21.hpp"
#include "gearwright/cad/walls.hpp"

namespace gearwright {

/// Points, edges and faces of a solid agree within this distance, mm. The file states this distance
/// as its uncertainty.
inline constexpr double kBrepUncertainty_mm = 1e-7;
static_assert(kHelixTarget_mm <= kBrepUncertainty_mm / 2);

struct Brep {
  Part21Id solid;  ///< a MANIFOLD_SOLID_BREP whose normals point outwards
  std::size_t face_count;
  std::size_t edge_count;  ///< number of edges; each shared edge counts once
};

/// The faces of a gear, which are its walls and, if its flanks are modified, the fit of its teeth.
struct GearFaces {
  BodyWalls walls;
  std::optional<ModifiedFit> fit;
};

/// Writes the solid of a body in its own frame, without its pose. `gears` has one element for each
/// of body.gears().
///
/// Units     mm
/// Domain    walls = make_walls(gear), fit = fit_modified(*gear.modified, …); an internal gear has
///           a rim (contract)
/// Cost      proportional to the number of walls
Brep add_brep(Part21& out, const ToothedBody& body, const std::vector<GearFaces>& gears);

// Writes a rack as an advanced B-rep of a STEP file.
//
//   part of the tooth   surface                                edges on the border
//   land, flank         plane                                  lines
//   fillet              cylinder along the tooth, radius ρ_f   ellipses (circles for a spur rack)
//
// All surfaces and edges are exact. Every face of the teeth is a strip of the plan view
// (cad/rack_plan.hpp). A strip has four edges, and one more for each corner of the bar inside the
// strip. On a helical rack, the first strip begins at a corner of the bar, and the last strip ends
// at a corner. These two strips have one edge fewer.

/// Returns the number of faces. These are the strips, and five planes for the back, the two ends
/// and the two sides.
std::size_t rack_face_count(const ToothedBody& body);

/// Writes the solid of a rack in its own frame, without its pose.
///
/// Units     mm
/// Domain    a body that is a rack (contract)
Brep add_rack_brep(Part21& out, const ToothedBody& body);

}  // namespace gearwright
