// Computes the section of the bore, which is a circle with or without a rectangular keyway. For an
// internal gear (teeth < 0), the same functions compute the section of the rim, which is the outer
// cylinder around the teeth.
//
//   r  bore radius     w, t  keyway width and depth from the bore circle     all mm
//
// The keyway is a slot along +y. The flat floor of the keyway lies at y = r + t. The walls of the
// keyway at x = ±w/2 meet the bore at y = √(r² − w²/4). If w = 0, there is no keyway. The corners
// of the keyway, at the radius hypot(w/2, r + t), must lie inside the root circle.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/cad/mesh_builder.hpp"
#include "gearwright/cad/toothed_body.hpp"
#include "gearwright/cad/walls.hpp"

namespace gearwright {

/// Returns the columns of the wall (cad/mesh_builder.hpp), counter-clockwise from the lowest point
/// (0, −r). The columns are exactly symmetric about the y axis. Their normals point into the hole.
///
/// Accuracy  chords deviate from the circle by at most `chord` mm; the surface turns by at most
///           `facet_turn` rad over a chord
/// Domain    a bore for which hole_error() returns no error (contract)
std::vector<Column> bore_columns(const Bore& bore, double chord, double facet_turn);

/// Returns a single wall around the full circle, beginning on the +y axis.
WallLoop circle_loop(double radius);

/// Returns the walls of the bore or rim as a loop. If the sides of the keyway are shorter than
/// kShortestArc_mm, the keyway is omitted.
///
/// Errors    those of hole_error() (gear/bore.hpp)
/// Units     inner, outer: extreme radii of the outline, mm
Result<WallLoop> make_bore(const ToothedBody& body, double inner, double outer);

/// The bore, or the rim of an internal gear, as a closed counter-clockwise chain of arcs and lines.
struct BoreContour {
  double radius;               ///< r  mm
  bool keyway;                 ///< if false, the contour is the whole circle
  std::vector<Vec2> points;    ///< mm; a whole circle has two points
  std::vector<double> bulges;  ///< bulges[i] belongs to the piece from points[i] to the next point
};

/// Returns the contour of the bore or rim, or none if there is no bore.
///
/// Errors    those of hole_error() (gear/bore.hpp): a bore or keyway that reaches the root circle
///           or the groove, or an internal gear whose rim does not enclose the root circle
/// Units     inner, outer: smallest and greatest radius of the outline, mm
Result<std::optional<BoreContour>> bore_contour(const ToothedBody& body, double inner,
                                                double outer);

}  // namespace gearwright
