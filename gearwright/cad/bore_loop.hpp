// Section of the bore: a circle, or a circle with a rectangular keyway. The bore of an internal
// gear (teeth < 0) is its rim, the cylinder around its roots. The section is provided as mesh
// columns, as walls of a solid and as a drawing contour.
//
//   r  bore radius     w, t  keyway width and depth from the bore circle     all mm
//
// The keyway is a slot along +y. Its flat floor lies at y = r + t and its walls at x = ±w/2, which
// meet the bore at y = √(r² − w²/4). If w = 0, there is no keyway. The corner of the keyway,
// hypot(w/2, r + t), must lie inside the root.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/cad/mesh_builder.hpp"
#include "gearwright/cad/toothed_body.hpp"
#include "gearwright/cad/walls.hpp"

namespace gearwright {

/// The columns of the wall, counter-clockwise from the lowest point (0, −r), which is on the
/// circle. They are symmetric about the y axis bit for bit. Normals point into the hole.
///
/// Accuracy  chords deviate from the circle by at most `chord` mm and turn by at most `facet_turn`
///           rad
/// Domain    a bore for which bore_error() returns no error (contract)
std::vector<Column> bore_columns(const Bore& bore, double chord, double facet_turn);

/// One wall, from the +y axis around the full circle.
WallLoop circle_loop(double radius);

/// The loop of walls, without the slot if its sides would be slivers.
///
/// Errors    those of hole_error
/// Units     inner, outer: extreme radii of the outline, mm
Result<WallLoop> make_bore(const ToothedBody& body, double inner, double outer);

/// The bore, or the rim of an internal gear, as a closed chain of arcs and lines,
/// counter-clockwise.
struct BoreContour {
  double radius;               ///< r  mm
  bool keyway;                 ///< if false, the contour is the whole circle
  std::vector<Vec2> points;    ///< mm; a whole circle has two
  std::vector<double> bulges;  ///< tan(sweep/4); bulges[i] leads from points[i] to the next
};

/// Returns no contour if there is no bore.
///
/// Errors    as make_walls (cad/walls.hpp): a bore or keyway that crosses the root, or an internal
///           gear whose rim does not enclose the root
/// Units     inner, outer: extreme radii of the outline, mm
Result<std::optional<BoreContour>> bore_contour(const ToothedBody& body, double inner,
                                                double outer);

}  // namespace gearwright
