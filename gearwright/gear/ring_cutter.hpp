// The default pinion cutter of an internal gear, used if the drawing names no cutter.
//
// A drawing of an internal gear gives tip, root and thickness of the teeth, but seldom the cutter.
// The root fillet needs a cutter, so this file uses one without profile shift whose tip reaches the
// root circle and is rounded like the basic rack of the internal gear.
//                            theory: docs/theory/06-few-teeth.md, 6.5
#pragma once

#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// The internal gear with the tooth cut by a cutter of |z|/2 teeth, or of more or fewer teeth if
/// that cutter would remove part of the flank. All other data are unchanged. None if no such cutter
/// leaves the whole flank down to the tip.
///
/// Domain    `ring` is an internal gear without a tooth (contract)
std::optional<Gear> cut_by_default(const Gear& ring);

}  // namespace gearwright
