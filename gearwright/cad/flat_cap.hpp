// Triangulates plane regions, which are the end faces of bodies.
//
// A triangulation covers a region exactly once if all its triangles are counter-clockwise and its
// boundary is the boundary of the region. The reason is that the boundary winds once about each
// inner point, and each triangle that contains the point adds one to the winding number. The
// triangles of both functions here are counter-clockwise.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/cad/mesh.hpp"

namespace gearwright {

/// Triangulates a simple polygon by ear clipping. Each step cuts off the ear that is least acute,
/// which means that its smallest angle is the largest among all ears.
///
/// Work      O(n²) for n corners
/// Returns   n − 2 counter-clockwise triangles as corner indices; nothing if the polygon crosses
///           itself and no ear is left
/// Domain    a counter-clockwise polygon, n ≥ 3 (contract)
std::optional<std::vector<Triangle>> clip_ears(const std::vector<Vec2>& polygon);

/// Triangulates the region between an inner loop and a regular polygon around it. The loop and the
/// polygon are counter-clockwise about the origin and sorted by polar angle.
///
/// The inner loop is a circle, or a circle with a rectangular slot. Let δ be the angle between two
/// neighbouring outer corners, R their radius and r the largest inner radius. If R cos δ ≥ r, all
/// triangles are counter-clockwise, for two reasons. An outer step never crosses the circle with
/// radius r. An inner step is taken only if an outer corner lies within δ of both ends of the step.
///
/// Returns   triangles as indices: i means inner[i], inner.size() + j means outer[j]
/// Domain    the condition above; the first inner point lies on the circle and not in the slot
///           (contract)
std::vector<Triangle> zip_ring(const std::vector<Vec2>& inner, const std::vector<Vec2>& outer);

}  // namespace gearwright
