// What the profile shifts of a pair do to its centrodes: the reference circles at the reference
// centre distance, where they roll on each other, and the working pitch circles that do it instead
// at the distance of the pair.
//
//   I    where the reference circles touch, at a_d      I′   the pitch point at a
//                                              theory: docs/theory/06-few-teeth.md, 6.2
#pragma once

#include <string>

#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// Whether there is something to see: parallel axes, a shift of the centre distance of at least
/// 0.02 m_n, and a reason in the gears for it (shifts, or a gear cut by a pinion cutter).
bool centrodes_are_worth_a_picture(const InvolutePair& pair);

/// The two figures; empty where they say nothing.
std::string centrode_figures(const InvolutePair& pair);

}  // namespace gearwright
