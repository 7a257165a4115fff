// A double-helical pair under torque, from the results of its halves.
//
// The axial forces on a gear that floats along its axis cancel, so each half carries half of the
// torque. With the deflection of its teeth, each half has a loaded transmission error of its own,
// and the whole gears have the mean of both, as without load.
//                                    theory: docs/theory/12-loaded-contact.md, [T12.26]
#pragma once

#include <array>

#include "gearwright/load/load_summary.hpp"

namespace gearwright {

/// The half at z < 0, from the result of its mirror image in the plane z = 0: values along the face
/// in the order of z, and the rotations of the gear, which are those of the half minus `behind`.
/// `whole_pitch` is true if the positions are evenly spaced over one pitch.
LoadedContact second_half(LoadedContact image, Angle behind, bool whole_pitch);

/// The whole gears under twice the torque of a half. Values along the face, shares and stress fields
/// are those of the halves and are left empty. Maxima are those of both halves.
///
/// Formula   [T12.26]
/// Domain    the same torques and rotations in both halves; `base_radius` of gear 1, mm, for line
///           contact (contract)
LoadedContact whole_load(const std::array<const LoadedContact*, 2>& half, double base_radius,
                         bool whole_pitch);

}  // namespace gearwright
