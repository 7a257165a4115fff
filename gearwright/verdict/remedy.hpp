// Remedies of findings, each tried before it is printed.
//
// For each code a table names the numbers of the spec that can help and in which direction. For
// each number, the least change is computed that removes the finding and adds or worsens no other.
// Of several changes, the one with the fewest remaining findings is used. The remedy states the
// number that was tried, with the digits that were tried. A finding that no single change removes
// has no remedy.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/pair/pair.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright::detail {

/// Fills `remedy` of the findings, worst first, and `change` of the findings of the worst level
/// only, because the others are treated after them.
void add_remedies(std::vector<Finding>& findings, const Judged& judged, const TryChange& attempt);

}  // namespace gearwright::detail
