// Remedies of findings. Each remedy is tried before it is printed.
//
// For each finding code, a table lists the numbers of the spec that can help and the direction in
// which to change them. For each of these numbers, the program computes the smallest change that
// removes the finding and neither adds nor worsens another finding. If several changes succeed, the
// one with the fewest remaining findings is used. If the contact lies near the end of the face, the
// change is the one that moves it to the middle. If no change succeeds, the remedy contains no
// number.
#pragma once

#include <vector>

#include "gearwright/pair/pair.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright::detail {

/// Fills `remedy` of all findings. `change` is filled only for the findings of the worst level,
/// because the user removes these first.
void add_remedies(std::vector<Finding>& findings, const Judged& judged, const TryChange& attempt);

}  // namespace gearwright::detail
