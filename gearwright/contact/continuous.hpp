// Computes the extremes of the transmission error over all rotations from touches at some of them.
//
//   T, N       gap field of two flanks (gap_field.hpp) and frame N (contact_pair.hpp)
//   T_a, T_b   two branches. A branch is the greatest T of one tooth pair as a function of the
//              rotation. On convex flanks, it is the greatest T over all pairs of patches. On other
//              flanks, each pair of patches has its own branch. On wavy flanks, each crest has one
//   TE         the greatest T of all branches; the branch with this T leads
//                                        theory: docs/theory/14-scatter.md, [T14.11]
//
// A maximum of TE lies inside a branch or at its end. A minimum lies inside a branch or at a
// handover, where T_a = T_b. TE jumps if a branch begins or ends with a greater T than all others.
//
// If only the values at the positions are used, the greatest minus the least TE is too small. The
// missing part depends on where the handovers lie between the positions. It is at most half of the
// change of TE within a step.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/base/angle.hpp"
#include "gearwright/contact/sensitivity.hpp"

namespace gearwright {

/// The extremes of TE over a pitch in the frame N, rad.
struct CurveExtremes {
  double least, greatest;
  PairTouch top;  ///< the touch with the greatest value
  /// The touch with the least value, and a touch without contact. If the least value is at a
  /// handover, one touch of each branch.
  std::array<PairTouch, 2> bottom;
  double span() const { return greatest - least; }
};

/// Computes the extremes of the continuous curve from the touches of one_pitch().
///
/// Formula   [T14.11]
/// Units     rad
/// Domain    at least one touch with contact (contract)
/// Accuracy  1e-12 rad at the extremes that are found; at a jump, 1.5e-5 of the change of TE in a
///           step. A branch that leads for less than a step may be overlooked
/// Laws      (1) the range from `least` to `greatest` contains TE of all touches
///           (2) the result does not depend on the number of positions
CurveExtremes continuous_extremes(Transmission& transmission,
                                  const std::vector<PairTouch>& touches);

/// The least number of positions per pitch that is used to find the extremes of a pitch.
inline constexpr int kLeastSpanPositions = 32;

/// Returns the peak to peak of the continuous curve over a pitch, or none if contact is lost at a
/// position. The function uses at least kLeastSpanPositions.
std::optional<Angle> continuous_span(const ContactPair& pair, int positions);

/// Returns ∂span/∂e in rad per unit of the error e that `influence` describes. `transmission` must
/// be the one that computed `extremes`.
///
/// Formula   [T8.10] inside a branch, [T14.16] at a handover
/// Domain    as sensitivity() (contract)
/// Accuracy  rounding if the extremes are unique. At a jump, only the slope of the branch is used.
///           The motion of the end of the branch is neglected
/// Laws      (3) the result is the limit of difference quotients of span()
double span_slope(Transmission& transmission, const CurveExtremes& extremes,
                  const Influence& influence);

}  // namespace gearwright
