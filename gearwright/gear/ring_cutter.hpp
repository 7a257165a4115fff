// The default pinion cutter of an internal gear, which is used if the drawing names no cutter.
//
// A drawing of an internal gear gives tip, root and thickness of the teeth, but seldom the cutter, which
// determines the root fillet. The default cutter has no profile shift. Its tip reaches the root circle
// and is rounded like the basic rack of the internal gear.
//                            theory: docs/theory/06-few-teeth.md, 6.5
#pragma once

#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// The internal gear with a tooth cut by a cutter of |z|/2 teeth. If this cutter would remove part of
/// the flank, one with more or fewer teeth is used. All other data are unchanged. None if no cutter
/// leaves the whole flank down to the tip.
///
/// Domain    `ring` is an internal gear without a tooth (contract)
std::optional<Gear> cut_by_default(const Gear& ring);

}  // namespace gearwright
