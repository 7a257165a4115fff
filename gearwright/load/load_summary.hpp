// What a course of positions under one torque comes to: peak to peak, waves, stiffness, extremes.
//                                    theory: docs/theory/12-loaded-contact.md
#pragma once

#include "gearwright/load/loaded_contact.hpp"

namespace gearwright {

struct SummaryBasis {
  double face;         ///< b  mm, common
  double base_radius;  ///< r_b1  mm
  double body_twist;   ///< of both bodies, mm per N/mm
  bool whole_pitch;    ///< the positions are even over one pitch
  LoadRegime regime;   ///< of points only `whole_pitch` counts
};

/// Fills in what follows from `torque` and `positions`.
void summarise(LoadedTorque& torque, const SummaryBasis& basis);

/// The share of a tooth pair, whatever number of places it touches at.
double share_of(const LoadedPosition& position, int pair);

/// The torque at which the loaded transmission error is least, peak to peak, of two or more;
/// nullptr: one alone, or rotations instead of a pitch.
const LoadedTorque* quietest(const LoadedContact& contact);

}  // namespace gearwright
