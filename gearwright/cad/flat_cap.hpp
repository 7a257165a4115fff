// Triangulations of plane regions, for the two ends of a body.
//
// A triangulation covers the region exactly once if all its triangles turn counter-clockwise and
// its boundary is that of the region: the boundary winds once about each inner point, and each
// triangle that contains the point adds one to that number. Both functions preserve the
// orientation.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/cad/mesh.hpp"

namespace gearwright {

/// Triangulates a simple polygon by repeatedly cutting off the ear with the widest smallest angle.
///
/// Work      O(n²) for n corners
/// Returns   n − 2 counter-clockwise triangles of corner indices; nothing if the polygon crosses
///           itself so that no ear is left
/// Domain    counter-clockwise, n ≥ 3 (contract)
std::optional<std::vector<Triangle>> clip_ears(const std::vector<Vec2>& polygon);

/// Triangulates the region between an inner loop and a regular polygon around it, both
/// counter-clockwise about the origin and sorted by polar angle.
///
/// The inner loop is a circle, or a circle with a rectangular slot. Let δ be the angle between two
/// outer corners, R their radius and r the largest inner radius. If R cos δ ≥ r, every triangle
/// turns counter-clockwise: an outer step never crosses the inner circle r, and an inner step is
/// taken only if an outer corner lies within δ of both of its ends.
///
/// Returns   triangles of indices: i for inner[i], inner.size() + j for outer[j]
/// Domain    the condition above; the first inner point lies on the circle and not in the slot
///           (contract)
std::vector<Triangle> zip_ring(const std::vector<Vec2>& inner, const std::vector<Vec2>& outer);

}  // namespace gearwright
