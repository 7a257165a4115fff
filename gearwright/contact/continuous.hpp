// The least and the greatest transmission error of the continuous curve, computed from touches at
// some positions.
//
//   T_a, T_b   two branches: a tooth pair on a pair of patches, as a function of the rotation
//   TE = max over the branches, so that a maximum lies inside a branch or at its end, and a minimum inside
//   one or at a handover T_a = T_b; where a branch begins ahead of the others TE jumps
//                                        theory: docs/theory/14-scatter.md, [T14.11]
//
// The peak to peak at the positions alone is too small by up to half a slope times a step, and the
// missing part varies with the phase of the handovers.
#pragma once

#include <vector>

#include "gearwright/contact/transmission.hpp"

namespace gearwright {

/// rad, in N.
struct CurveExtremes {
  double least, greatest;
  double span() const { return greatest - least; }
};

/// `touches` are those of one_pitch().
///
/// Formula   [T14.11]
/// Units     rad
/// Domain    at least one touch that is found (contract)
/// Accuracy  1e-12 rad at the extremes that are found, and at a jump 1.5e-5 of the change of TE in
///           a step. A branch that is greatest for less than a step may be missed
/// Laws      (1) least is at most, and greatest at least, that of the touches
CurveExtremes continuous_extremes(Transmission& transmission,
                                  const std::vector<PairTouch>& touches);

}  // namespace gearwright
