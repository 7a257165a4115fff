// Combines all missing inputs in one error, so that a user with an almost empty input sees all of
// them at once.
#pragma once

#include <vector>

#include "gearwright/base/error.hpp"

namespace gearwright {

/// The first error, with the others appended to its rule: "…; also missing: rating.quality (the
/// accuracy grades …), …". Each field and each explanation occurs once. If an error has another
/// kind than `missing`, that error is returned alone.
///
/// Domain    at least one error (contract)
Error all_missing(const std::vector<Error>& errors);

}  // namespace gearwright
