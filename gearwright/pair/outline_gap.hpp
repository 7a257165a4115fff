// Computes the play of two finished outlines on parallel axes. At every rotation of the pair, gear
// 2 is turned from the middle of its play until a point of one tooth touches the other gear. This
// method finds every part of the outlines that projects too far.
//
//   φ      rotation of the pair            a    centre distance, mm
//   g      gap, as the rotation of gear 2 that closes it, rad; < 0 if the outlines overlap
//   h      arm of the common normal about axis 2, mm; g h is the gap along the normal
//                                     theory: docs/theory/02-involute-and-pair.md, [T2.29]…[T2.33]
#pragma once

#include <array>
#include <limits>
#include <optional>

#include "gearwright/generation/outline.hpp"

namespace gearwright {

/// The position of a touch on an outline: an arc, or the corner that has the name of this arc.
struct OutlinePlace {
  ArcName arc;
  bool corner;
};

/// The least gap of two outlines.
struct OutlineTouch {
  double gap = std::numeric_limits<double>::infinity();  ///< g  rad
  double arm = 0.0;                                      ///< h  mm
  double rotation_1 = 0.0;  ///< rotation of gear 1 at the touch, clockwise, within half a pitch
  double turn_2 = 0.0;      ///< ±g, the counter-clockwise rotation of gear 2 that closes the gap
  Vec2 point{0.0, 0.0};     ///< position in the housing frame, mm
  double height = 0.0;      ///< position along axis 1, mm; 0 on parallel axes
  std::array<OutlinePlace, 2> places{};

  /// Returns the distance between the two touching points, mm along the common normal, to first
  /// order. `play` is the rotation of gear 2 from the middle of its play towards the touch. If the
  /// distance is < 0, its magnitude is the depth of the overlap.
  double distance(double play = 0.0) const { return (gap - play) * arm; }
};

struct OutlineGap {
  static constexpr int kNames = 5;
  using Row = std::array<std::optional<OutlineTouch>, kNames>;
  std::array<Row, kNames> touches;  ///< least gap for each pair of arc names, [gear 1][gear 2]

  const std::optional<OutlineTouch>& of(ArcName arc_1, ArcName arc_2) const;
  /// Returns the touch with the least gap, or none if the gears do not reach each other. The true
  /// play is twice this gap.
  std::optional<OutlineTouch> least() const;
  /// Returns the touch with the least gap, except touches of a flank with a flank.
  std::optional<OutlineTouch> least_beyond_flanks() const;
  int evaluations = 0;  ///< number of evaluated gaps, for performance counts
};

/// Returns the gaps of two outlines for each pair of arc names.
///
/// Formula   [T2.29]…[T2.33]
/// Units     mm, rad
/// Domain    outlines with arcs; gear 1 is external, and an internal gear is gear 2 with more teeth
///           (contract). A tip below the mating root circle gives no gap; the tip clearance is < 0
///           in this case
/// Accuracy  every gap is computed for two points of the outlines. Except for rounding, the result
///           is therefore not less than the true least gap. If the least gap of two arcs is less
///           than `limit`, the result exceeds it by at most 1e-12 rad. This requires that, between
///           neighbouring samples (nine per family), the gap falls below the chord by at most half
///           of the second difference. If the least gap exceeds `limit`, the result is the least
///           evaluated value
OutlineGap outline_gap(const Outline& gear_1, const Outline& gear_2, double center_distance,
                       double limit = std::numeric_limits<double>::infinity());

}  // namespace gearwright
