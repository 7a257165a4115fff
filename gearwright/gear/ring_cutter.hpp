// The pinion cutter of an internal gear whose drawing names none.
//
// A drawing of an internal gear says where the teeth end and how thick they are, seldom what cut
// them. The root fillet still needs a cutter: here one without profile shift whose tip reaches the
// root circle and is rounded like the internal gear's basic rack.
//                            theory: docs/theory/06-few-teeth.md, 6.5
#pragma once

#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// The internal gear with the tooth that a cutter of |z|/2 teeth leaves, or of more or fewer where
/// that one would take some of the flank. Its data stay as they are. Nothing: no such cutter leaves
/// the whole flank down to the tip.
///
/// Domain    `ring` is an internal gear without a tooth (contract)
std::optional<Gear> cut_by_default(const Gear& ring);

}  // namespace gearwright
