// Computes the gear that the whole outline of a pinion cutter generates. The cutter is given by its
// finished tooth.
//
// Every arc of the cutter gives branches, just as with the edge of a rack. Every convex corner also
// gives branches, with its range of normals. The tip of the cutter cuts the root of the gear, and
// the root of the cutter cuts the tip of the gear. The concave root of the cutter may cut cusps on
// the tip of the gear.
//                                              theory: docs/theory/06-few-teeth.md, [T6.8]…[T6.13]
#pragma once

#include "gearwright/generation/generate.hpp"
#include "gearwright/generation/pinion_envelope.hpp"

namespace gearwright {

/// Returns the radius, mm, at which the root of the cutter ends the tooth, if the blank does not
/// end the tooth earlier.
double left_by_root(const GeneratedTooth& cutter, const PinionMotion& motion);

/// Cuts a tooth with a pinion cutter.
///
/// Units     mm, rad; if `blank_radius` is infinite (internal gear: 0), the root of the cutter ends
///           the tooth
/// Domain    `cutter` has an outline; an internal gear has more teeth than its cutter (contract)
/// Errors    `cut_by` if the centrode lies inside the base circle of the cutter, if the cutter
///           leaves no tooth, or if the branches do not join; `tip_diameter` if the blank ends at
///           the root
Result<GeneratedTooth> cut_by_pinion(const GeneratedTooth& cutter, const PinionMotion& motion,
                                     double blank_radius);

}  // namespace gearwright
