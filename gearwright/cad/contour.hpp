// Computes the closed outline of a whole gear in the transverse section z = 0 as a chain of pieces.
//
//   k     tooth number, 0 … |z| − 1; tooth k is tooth 0 turned by 2πk/|z|, and quarter turns are
//         exact
//
// For external and internal gears, the contour runs counter-clockwise about the axis. It begins
// with the tip land of tooth 0 and the upper half of tooth 0 from tip to root. The root land and
// the lower (mirrored) half of tooth 1 from root to tip follow. The next piece is the tip land of
// tooth 1, and so on. Both halves of a land form one piece, a true circle about the axis. Every
// other piece is an arc of the outline, mirrored and turned.
//
//   Laws  (1) the end of each piece is identical to the start of the next, and the contour is
//             closed
//         (2) the number of pieces is |z| times the number for one tooth
//         (3) a pointed tooth has no tip land, and a full-radius root has no root land; the
//             adjacent pieces then meet in a point on the centre line of the tooth or the space
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/cad/toothed_body.hpp"
#include "gearwright/generation/outline.hpp"

namespace gearwright {

struct ContourPiece {
  std::size_t arc;  ///< index into Outline::arcs
  int tooth;        ///< k; for a root land, one of the adjacent teeth
  bool mirrored;    ///< true on the lower half of the tooth, where the piece runs from root to tip
  bool land;        ///< true if the piece is a land with both halves; on a rack, a land is a line
  Vec2 begin;       ///< mm
  Vec2 end;         ///< mm
  double sweep;     ///< rad, > 0 for a land of a gear; otherwise 0
};

struct Contour {
  int teeth;  ///< |z|
  std::vector<ContourPiece> pieces;
  double inner_radius;  ///< smallest radius of the outline at the examined points, mm; 0 for a rack
  double outer_radius;  ///< greatest radius of the outline, mm
  /// Set only for a rack. The outline shifted along y by `rack->middle_of(k, teeth)` is tooth k of
  /// the rack.
  std::optional<RackBlock> rack{};
};

/// Connects the outlines of all teeth into one closed contour. If an arc is shorter than 1e-6 mm,
/// it gives no piece, and the next piece begins at the start of this arc.
///
/// Errors    if the outline crosses the centre line of the tooth or of the space (severed
///           tooth)
/// Domain    teeth ≠ 0; at least one arc; arcs joined without any gap; the first point on the
///           ray π/|z| and the last one on the x axis within 1e-6 mm (contract)
Result<Contour> closed_contour(const Outline& outline);

/// Returns the contour of a rack with its teeth, ends and back, counter-clockwise. Lands, ends and
/// back are straight lines.
///
/// Domain    teeth ≥ 1; a back below the roots; the laws of pair/rack_pair.hpp hold (contract)
Contour rack_contour(const Outline& outline, const RackBlock& rack);

/// Moves points on an arc of the half outline to the position and direction of a piece. The points
/// are given from root to tip. They are either mirrored or reversed. Then they are turned or, on a
/// rack, shifted. The ends of the piece replace the first and the last point.
///
/// Domain    the piece is not a land, there are at least two points, and the moved end points
///           lie within 3e-6 mm of the ends of the piece (contract)
std::vector<Vec2> placed(const Contour& contour, const ContourPiece& piece,
                         const std::vector<Vec2>& root_to_tip);

}  // namespace gearwright
