// Computes the loaded contact of a double-helical pair from the results of its two halves.
//
// The axial forces on a gear that floats along its axis cancel, so each half carries half of the
// torque. The loaded transmission error of the whole gears is the mean of the loaded transmission
// errors of both halves. This also holds without load.
//                                    theory: docs/theory/12-loaded-contact.md, [T12.26]
#pragma once

#include <array>

#include "gearwright/load/load_summary.hpp"

namespace gearwright {

/// Returns the result of the half at z < 0, computed from the result of its mirror image in the
/// plane z = 0. Values along the face are put into the order of z, and `behind` is subtracted from
/// the rotations. `whole_pitch` is true if the positions are evenly spaced over one pitch.
LoadedContact second_half(LoadedContact image, Angle behind, bool whole_pitch);

/// Returns the result for the whole gears under twice the torque of a half. Maxima are taken over
/// both halves. The result does not contain values along the face, shares of the tooth pairs or
/// stress fields, because the results of the halves contain them.
///
/// Formula   [T12.26]
/// Domain    the same torques and rotations in both halves (contract)
LoadedContact whole_load(const std::array<const LoadedContact*, 2>& half, const Gear& gear_1,
                         bool whole_pitch);

}  // namespace gearwright
