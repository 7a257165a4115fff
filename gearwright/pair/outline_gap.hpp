// The play of two finished outlines on parallel axes: how far gear 2 turns, from the middle of its
// play, until some point of one tooth meets the other, over all positions. No part of a tooth has
// to have a name for that: whatever juts out is found.
//
//   φ      rotation of the pair            a    centre distance, mm
//   g      gap: the turn of gear 2 that closes it, rad; < 0: the outlines overlap by that much
//   h      arm of the common normal about axis 2, mm: g h is the gap along the normal
//                                     theory: docs/theory/02-involute-and-pair.md, [T2.29]…[T2.33]
#pragma once

#include <array>
#include <limits>
#include <optional>

#include "gearwright/generation/outline.hpp"

namespace gearwright {

/// Where an outline is touched: on an arc, or in the corner in which that arc ends the tooth.
struct OutlinePlace {
  ArcName arc;
  bool corner;
};

/// Two outlines as near as they come.
struct OutlineTouch {
  double gap = std::numeric_limits<double>::infinity();  ///< g  rad
  double arm = 0.0;                                      ///< h  mm
  double rotation_1 = 0.0;  ///< of gear 1 when they touch, as Pair counts it, within half a pitch
  double turn_2 = 0.0;   ///< ±g, which closes it: counter-clockwise, from the middle of the play
  Vec2 point{0.0, 0.0};  ///< where, in the housing frame, mm
  double height = 0.0;   ///< along axis 1, mm; on parallel axes every section is alike
  std::array<OutlinePlace, 2> places{};

  /// Along the common normal, mm, gear 2 turned by `play` from the middle towards it; < 0: so deep
  /// do the outlines overlap, to first order.
  double distance(double play = 0.0) const { return (gap - play) * arm; }
};

struct OutlineGap {
  static constexpr int kNames = 5;
  using Row = std::array<std::optional<OutlineTouch>, kNames>;
  std::array<Row, kNames> touches;  ///< least by the names of the arcs, of gear 1 and of gear 2

  const std::optional<OutlineTouch>& of(ArcName arc_1, ArcName arc_2) const;
  /// The least of all; none where the gears do not reach each other. Half the true play.
  std::optional<OutlineTouch> least() const;
  /// The least of all that are not flank on flank.
  std::optional<OutlineTouch> least_beyond_flanks() const;
  int evaluations = 0;  ///< of gaps, for who counts work
};

/// The gap of two outlines, by the names of the arcs.
///
/// Formula   [T2.29]…[T2.33]
/// Units     mm, rad
/// Domain    outlines with arcs; external: both of external teeth; internal: gear 2 is the
///           internal gear (contract). What lies below a root circle is no gap but a tip clearance < 0.
/// Accuracy  every gap is that of two points of the outlines, to rounding: none is too small. The
///           least of a pair of arcs is too great by 1e-12 rad at most if it is less than `limit`,
///           as long as no gap dips between two of nine places by more than half of the second
///           difference about them; from `limit` on it is what was met on the way
OutlineGap outline_gap(const Outline& gear_1, const Outline& gear_2, double center_distance,
                       double limit = std::numeric_limits<double>::infinity());

}  // namespace gearwright
