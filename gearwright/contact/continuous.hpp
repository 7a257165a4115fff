// The least and the greatest transmission error of the continuous curve, computed from touches at
// some positions.
//
//   T_a, T_b   two branches: a tooth pair on a pair of patches, as a function of the rotation
//   TE         the greatest of the branches. A maximum lies inside a branch or at its end, and a
//              minimum inside a branch or at a handover T_a = T_b. TE jumps where a branch begins
//              ahead of the others
//                                        theory: docs/theory/14-scatter.md, [T14.11]
//
// The peak to peak at the positions alone is too small by up to half a slope times a step, and the
// missing part varies with the phase of the handovers.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/base/angle.hpp"
#include "gearwright/contact/sensitivity.hpp"

namespace gearwright {

/// rad, in N.
struct CurveExtremes {
  double least, greatest;
  PairTouch top;                    ///< the touch with the greatest value
  std::array<PairTouch, 2> bottom;  ///< the touch with the least value; at a handover one on each
                                    ///< branch
  double span() const { return greatest - least; }
};

/// `touches` are those of one_pitch().
///
/// Formula   [T14.11]
/// Units     rad
/// Domain    at least one touch that is found (contract)
/// Accuracy  1e-12 rad at the extremes that it finds, at a jump 1.5e-5 of the change of TE in a
///           step; a branch that leads for less than a step may be overlooked
/// Laws      (1) least is at most, and greatest at least, that of the touches   (2) the result does
///           not depend on the number of positions
CurveExtremes continuous_extremes(Transmission& transmission,
                                  const std::vector<PairTouch>& touches);

/// Peak to peak of the continuous curve over a pitch; none if contact is lost at some position.
///
/// Domain    positions ≥ 2 (contract)
std::optional<Angle> continuous_span(const ContactPair& pair, int positions);

/// ∂span/∂e, rad per unit of e. `transmission` is that of the extremes.
///
/// Formula   of a branch [T8.10], of a handover [T14.16]
/// Domain    as sensitivity() (contract)
/// Accuracy  rounding, where the extremes are unique; at a jump that of the branch, without the motion
///           of its end
/// Laws      (3) it is the limit of differences of span()
double span_slope(Transmission& transmission, const CurveExtremes& extremes,
                  const Influence& influence);

}  // namespace gearwright
