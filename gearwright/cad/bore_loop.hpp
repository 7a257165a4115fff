// The bore's section: a circle, or a circle with a rectangular keyway; of a ring (teeth < 0) its rim,
// the cylinder round its roots. As columns of a mesh, walls of a solid, and contour of a drawing.
//
//   r  bore radius     w, t  keyway width and depth from the bore circle     all mm
//
// The keyway is a slot along +y: its flat floor lies at y = r + t, its walls at x = ±w/2, which meet
// the bore at y = √(r² − w²/4); w = 0: no keyway. Its corner, hypot(w/2, r + t), must lie inside the
// root.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/cad/mesh_builder.hpp"
#include "gearwright/cad/toothed_body.hpp"
#include "gearwright/cad/walls.hpp"

namespace gearwright {

/// bore_error() of a ring, whose bore is its rim: it must lie around its roots and has no keyway.
///
/// Domain    `room` mm: the radius that the rim must reach
std::optional<Error> rim_error(const ToothedBody& body, double room);

/// The wall's columns, counter-clockwise from the lowest point (0, −r), which is on the circle;
/// symmetric about the y axis bit for bit. Normals point into the hole.
///
/// Accuracy  chords leave the circle by at most `chord` mm and turn by at most `facet_turn` rad
/// Domain    a bore without bore_error (contract)
std::vector<Column> bore_columns(const Bore& bore, double chord, double facet_turn);

/// The loop of walls, without a slot whose sides would be slivers.
///
/// Errors    those of bore_error and rim_error
/// Units     inner, outer: extreme radii of the outline, mm
Result<WallLoop> make_bore(const ToothedBody& body, double inner, double outer);

/// The bore, or the rim of an internal gear, as a closed chain of arcs and lines,
/// counter-clockwise.
struct BoreContour {
  double radius;               ///< r  mm
  bool keyway;                 ///< false: the whole circle
  std::vector<Vec2> points;    ///< mm; two of a whole circle
  std::vector<double> bulges;  ///< tan(sweep/4); bulges[i] leads from points[i] to the next
};

/// None without a bore.
///
/// Errors    rejected as by make_walls (cad/walls.hpp): a bore or keyway that crosses the root, an
///           internal gear's rim that does not enclose it
/// Units     inner, outer: extreme radii of the outline, mm
Result<std::optional<BoreContour>> bore_contour(const ToothedBody& body, double inner,
                                                double outer);

}  // namespace gearwright
