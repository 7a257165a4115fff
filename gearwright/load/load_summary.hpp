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
};

/// Fills in what follows from `torque` and `positions`.
void summarise(LoadedTorque& torque, const SummaryBasis& basis);

}  // namespace gearwright
