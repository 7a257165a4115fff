// Branches put together to the outline that they leave standing.
//
// Internal to generation/. A chain is a list of branches by growing height, each beginning where
// the one before ends; as a whole it is the half angle over the height.
//                            theory: docs/theory/03-rack-and-generation.md, [T3.11]…[T3.13]
#pragma once

#include <optional>
#include <vector>

#include "gearwright/generation/branch.hpp"

namespace gearwright::detail {

/// The chain of the branches of one edge, in its order from root to tip, up to the tip. Empty where
/// two ends that ought to meet do not.
std::vector<Branch> assemble(const std::vector<Branch>& branches, double tip_height);

/// The same from branches each of which only cuts: from the first, which begins at the root, on the
/// lowest half angle at every height. [T6.13] Slower than the walk along an edge, for cutters whose
/// way turns back.
std::vector<Branch> lower_envelope(const std::vector<Branch>& branches, double tip_height);

/// Whether every branch begins where the one before ends.
bool is_continuous(const std::vector<Branch>& chain);

}  // namespace gearwright::detail
