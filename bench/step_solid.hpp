// A toothed body as a solid of the CAD kernel (OCCT). Only files named step* know the kernel.
//
//   u, v   of a face: u counter-clockwise about the axis, v upwards; v is z itself, mm
//
// Every edge is made once, from the poles that its two faces have in common, and used by both: one
// forward, one reversed. Level edges lie in the planes between slices, upright edges climb with the
// helix. All parameters agree by construction (an upright edge's parameter is z, a level edge's is
// its wall's u), so no edge needs sewing and 1e-7 mm is an honest tolerance: what deviates at all
// is the spline of the helix on a true cylinder, by less than kHelixTarget_mm.
#pragma once

#include <TopoDS_Solid.hxx>
#include <cstddef>
#include <vector>

#include "gearwright/cad/step.hpp"
#include "gearwright/cad/walls.hpp"

namespace gearwright {

struct StepSolid {
  TopoDS_Solid solid;           ///< in the gear's own frame, outside out
  std::vector<StepFace> faces;  ///< of half a tooth, body = 0
  std::size_t face_count;
  std::size_t edge_count;
};

/// Tolerance of every vertex, edge and face, mm.
inline constexpr double kStepTolerance_mm = 1e-7;

/// The solid of a body in its own frame (the pose is not applied).
///
/// Units     mm
/// Facts     those of make_walls
/// Cost      linear in |z|: one pitch is fitted, the others are copies of its poles
Result<StepSolid> make_solid(const ToothedBody& body);

}  // namespace gearwright
