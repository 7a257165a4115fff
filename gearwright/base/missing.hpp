// Missing inputs are reported together, so that a user with an almost empty input learns all of
// them at once.
#pragma once

#include <vector>

#include "gearwright/base/error.hpp"

namespace gearwright {

/// The first error, with the others appended to its rule: "…; also missing: rating.quality (the
/// accuracy grades …), …". Each field and each explanation occurs once. If one of them is an error of
/// another kind, that error is returned alone.
///
/// Domain    at least one error (contract)
Error all_missing(const std::vector<Error>& errors);

}  // namespace gearwright
