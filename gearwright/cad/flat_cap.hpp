// Triangulations of plane regions, for the two ends of a body.
//
// A triangulation whose triangles all turn counter-clockwise and whose boundary is the region's own
// covers the region once: the boundary winds once about each inner point and each triangle that
// holds the point adds one to that number. Both functions keep that sign.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/cad/mesh.hpp"

namespace gearwright {

/// Triangles of a simple polygon, by cutting off the ear with the widest smallest angle.
///
/// Work      O(n²) for n corners
/// Returns   n − 2 counter-clockwise triangles of corner indices; nothing when the polygon crosses
///           itself so that no ear is left
/// Domain    counter-clockwise, n ≥ 3 (contract)
std::optional<std::vector<Triangle>> clip_ears(const std::vector<Vec2>& polygon);

/// Triangles of the internal gear between an inner loop and a regular polygon around it, both
/// counter-clockwise about the origin, sorted by polar angle.
///
/// The inner loop is a circle, or a circle with a rectangular slot. With δ the angle between two
/// outer corners, R their radius and r the largest inner radius, R cos δ ≥ r makes every triangle
/// turn counter-clockwise: an outer step never crosses the inner circle r, and an inner step is
/// taken only when an outer corner lies at most δ from either of its ends.
///
/// Returns   triangles of indices: i for inner[i], inner.size() + j for outer[j]
/// Domain    the above, the first inner point on the circle and not in the slot (contract)
std::vector<Triangle> zip_ring(const std::vector<Vec2>& inner, const std::vector<Vec2>& outer);

}  // namespace gearwright
