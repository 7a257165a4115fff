// Remedies of findings, each tried before it is printed.
//
// For each code a table names the numbers of the spec that can help and in which direction. For
// each number, the least change is computed that removes the finding and adds or worsens no other.
// Of several changes, the one with the fewest remaining findings is used. The remedy states the
// number that was tried, with the digits that were tried. A finding that no single change takes
// away has none.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/pair/pair.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright::detail {

/// Fills `remedy` of the findings, worst first, and `change` of those of the worst level: the others
/// come after.
void add_remedies(std::vector<Finding>& findings, const Judged& judged, const TryChange& attempt);

}  // namespace gearwright::detail
