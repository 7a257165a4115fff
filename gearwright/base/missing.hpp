// Inputs that are missing, told together: who starts from an almost empty input learns at once what
// all is wanted, not one thing after another.
#pragma once

#include <vector>

#include "gearwright/base/error.hpp"

namespace gearwright {

/// The first, whose rule goes on with the others: "…; also missing: rating.quality (the accuracy
/// grades …), …". A field counts once, and what is wanted is said once. Where one of them is another
/// kind of error it is told alone.
///
/// Domain    at least one (contract)
Error all_missing(const std::vector<Error>& errors);

}  // namespace gearwright
