// A finished tooth as a pinion cutter: what its whole outline leaves of the gear it rolls with.
//
// Every arc of the cutter, and every corner with its fan of normals, gives branches as the edge of
// a rack does; the cutter's tip cuts the root, its root the tip. Trimming, cusps (the cutter's
// hollow root may cut one on the tip) and pointed teeth are the same work.
//                                              theory: docs/theory/06-few-teeth.md, [T6.8]…[T6.13]
#pragma once

#include "gearwright/generation/generate.hpp"
#include "gearwright/generation/pinion_envelope.hpp"

namespace gearwright {

/// The tip radius that the cutter's root leaves where no blank ends the tooth before, mm.
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
