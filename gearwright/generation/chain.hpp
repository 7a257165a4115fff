// Joins branches to the outline of the tooth.
//
// Internal to generation/. A chain is a list of branches in order of height. Each branch begins at the
// end of the preceding branch, so the chain represents the half angle as a function of the height.
//                            theory: docs/theory/03-rack-and-generation.md, [T3.11]…[T3.13]
#pragma once

#include <vector>

#include "gearwright/generation/branch.hpp"

namespace gearwright::detail {

/// Returns the chain up to the tip, for branches in the order of the cutter's edge from root to tip. The
/// chain is empty if the ends of two neighbouring branches do not meet.
std::vector<Branch> assemble(const std::vector<Branch>& branches, double tip_height);

/// Returns the chain up to the tip, for branches in any order. The chain begins at the root with the
/// first branch and follows the lowest half angle at every height [T6.13]. This function is slower
/// than assemble() and is used for cutters whose path turns back.
std::vector<Branch> lower_envelope(const std::vector<Branch>& branches, double tip_height);

/// Returns true if every branch begins at the end of the preceding branch.
bool is_continuous(const std::vector<Branch>& chain);

}  // namespace gearwright::detail
