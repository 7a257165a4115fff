// Triangulates plane regions, which are the end faces of bodies.
//
// A triangulation covers a region exactly once if all its triangles are counter-clockwise and if
// its boundary is the boundary of the region. The reason is that the boundary winds once about each
// inner point, and each triangle around the point adds one to the winding number. Both functions
// here make counter-clockwise triangles.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/cad/mesh.hpp"

namespace gearwright {

/// Triangulates a simple polygon by ear clipping. Each step cuts off the least acute ear. This is
/// the ear whose smallest angle is the largest among all ears.
///
/// Work      O(n²) for n corners
/// Returns   n − 2 counter-clockwise triangles as corner indices; none if the polygon crosses
///           itself and no ear is left
/// Domain    a counter-clockwise polygon, n ≥ 3 (contract)
std::optional<std::vector<Triangle>> clip_ears(const std::vector<Vec2>& polygon);

/// Triangulates the region between an inner loop and a regular polygon around this loop. Both are
/// counter-clockwise about the origin and sorted by polar angle.
///
/// The inner loop is a circle, or a circle with a rectangular slot. Let δ be the angle between two
/// neighbouring outer corners, R their radius and r the largest inner radius. If R cos δ ≥ r, all
/// triangles are counter-clockwise, for two reasons. First, an outer step never crosses the circle
/// with the radius r. Second, an inner step is taken only if an outer corner lies within δ of both
/// ends of the step.
///
/// Returns   triangles as indices: i means inner[i], inner.size() + j means outer[j]
/// Domain    the condition above; the first inner point lies on the circle and not in the slot
///           (contract)
std::vector<Triangle> zip_ring(const std::vector<Vec2>& inner, const std::vector<Vec2>& outer);

}  // namespace gearwright
