// Joins branches to the outline of the region between them.
//
// Internal to generation/. A chain is a list of branches in order of height, each beginning at the
// end of the preceding one. It represents the half angle as a function of the height.
//                            theory: docs/theory/03-rack-and-generation.md, [T3.11]…[T3.13]
#pragma once

#include <optional>
#include <vector>

#include "gearwright/generation/branch.hpp"

namespace gearwright::detail {

/// Returns the chain of the branches of one edge, in its order from root to tip, up to the tip. The
/// chain is empty if two ends that should meet do not.
std::vector<Branch> assemble(const std::vector<Branch>& branches, double tip_height);

/// Returns the same chain for branches in any order. The chain begins at the root with the first
/// branch and follows the lowest half angle at every height [T6.13]. This function is slower than
/// the walk along an edge and is used for cutters whose path turns back.
std::vector<Branch> lower_envelope(const std::vector<Branch>& branches, double tip_height);

/// Returns true if every branch begins at the end of the preceding one.
bool is_continuous(const std::vector<Branch>& chain);

}  // namespace gearwright::detail
