// The play of two finished outlines on parallel axes: the rotation of gear 2, from the middle of
// its play, until some point of one tooth meets the other, over all positions. All projecting parts
// of a tooth are found, whether or not they have a name.
//
//   φ      rotation of the pair            a    centre distance, mm
//   g      gap: the turn of gear 2 that closes it, rad; < 0 if the outlines overlap by that much
//   h      arm of the common normal about axis 2, mm: g h is the gap along the normal
//                                     theory: docs/theory/02-involute-and-pair.md, [T2.29]…[T2.33]
#pragma once

#include <array>
#include <limits>
#include <optional>

#include "gearwright/generation/outline.hpp"

namespace gearwright {

/// The place of a touch on an outline: on an arc, or at the corner in which that arc ends the
/// tooth.
struct OutlinePlace {
  ArcName arc;
  bool corner;
};

/// The least gap of two outlines.
struct OutlineTouch {
  double gap = std::numeric_limits<double>::infinity();  ///< g  rad
  double arm = 0.0;                                      ///< h  mm
  double rotation_1 = 0.0;  ///< rotation of gear 1 at the touch, in the sense of Pair, within half
                            ///< a pitch
  double turn_2 = 0.0;   ///< ±g, which closes it: counter-clockwise, from the middle of the play
  Vec2 point{0.0, 0.0};  ///< position in the housing frame, mm
  double height = 0.0;   ///< along axis 1, mm; on parallel axes every section is equal
  std::array<OutlinePlace, 2> places{};

  /// Distance along the common normal, mm, with gear 2 turned by `play` from the middle towards it;
  /// < 0 is the depth of the overlap, to first order.
  double distance(double play = 0.0) const { return (gap - play) * arm; }
};

struct OutlineGap {
  static constexpr int kNames = 5;
  using Row = std::array<std::optional<OutlineTouch>, kNames>;
  std::array<Row, kNames> touches;  ///< least gap for each pair of arc names, of gear 1 and of gear
                                    ///< 2

  const std::optional<OutlineTouch>& of(ArcName arc_1, ArcName arc_2) const;
  /// The least of all; none if the gears do not reach each other. It is half the true play.
  std::optional<OutlineTouch> least() const;
  /// The least of all touches other than flank on flank.
  std::optional<OutlineTouch> least_beyond_flanks() const;
  int evaluations = 0;  ///< number of evaluated gaps, for performance counts
};

/// The gap of two outlines, by the names of the arcs.
///
/// Formula   [T2.29]…[T2.33]
/// Units     mm, rad
/// Domain    outlines with arcs; external: both of external teeth; internal: gear 2 is the
///           internal gear (contract). Below a root circle there is no gap but a tip clearance < 0.
/// Accuracy  every gap is that of two points of the outlines, to rounding, so none is too small.
///           The least of a pair of arcs is too great by at most 1e-12 rad if it is less than
///           `limit`, provided that no gap falls between two of nine places by more than half of
///           the second difference about them. Above `limit` it is the least evaluated value
OutlineGap outline_gap(const Outline& gear_1, const Outline& gear_2, double center_distance,
                       double limit = std::numeric_limits<double>::infinity());

}  // namespace gearwright
