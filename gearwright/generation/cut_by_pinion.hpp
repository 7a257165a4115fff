// A finished tooth as a pinion cutter: computes the gear that its whole outline generates.
//
// Every arc of the cutter, and every corner with its range of normals, gives branches, like the
// edge of a rack. The tip of the cutter cuts the root, and its root cuts the tip. Trimming, cusps
// (which the concave root of the cutter may cut on the tip) and pointed teeth need no separate
// treatment.
//                                              theory: docs/theory/06-few-teeth.md, [T6.8]…[T6.13]
#pragma once

#include "gearwright/generation/generate.hpp"
#include "gearwright/generation/pinion_envelope.hpp"

namespace gearwright {

/// The tip radius that the root of the cutter leaves if the blank does not end the tooth earlier,
/// mm.
double left_by_root(const GeneratedTooth& cutter, const PinionMotion& motion);

/// Cuts a tooth with a pinion cutter.
///
/// Units     mm, rad; `blank_radius` infinite (an internal gear: 0) leaves the tip to the cutter's
/// root
/// Domain    `cutter` has an outline; an internal gear has more teeth than its cutter (contract)
/// Errors    `cut_by` where the centrode lies inside the cutter's base circle, where the cutter
///           passes the axis or leaves no tooth; `tip_diameter_mm` when the blank ends at the root
Result<GeneratedTooth> cut_by_pinion(const GeneratedTooth& cutter, const PinionMotion& motion,
                                     double blank_radius);

}  // namespace gearwright
