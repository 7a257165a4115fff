// Remedies of findings. Each remedy is tried before it is printed.
//
// A table lists, for each code, the numbers of the spec that can help and their direction. For
// each number, the smallest change is computed that removes the finding and adds or worsens no other
// finding. If several changes succeed, the one with the fewest remaining findings is used. The
// remedy states the number that was tried, with all its digits. A finding that no single change
// removes has no remedy with a number.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/pair/pair.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright::detail {

/// Fills `remedy` of all findings. `change` is filled only for the findings of the worst level,
/// because findings of a lower level are treated later.
void add_remedies(std::vector<Finding>& findings, const Judged& judged, const TryChange& attempt);

}  // namespace gearwright::detail
