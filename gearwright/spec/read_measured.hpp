// Reads [gearN.measured], and the little that is known of a gear beside it.
// Internal to spec/.
#pragma once

#include <memory>
#include <string>

#include "gearwright/inspection/identify.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// A table of a gear with readings and without a module: identify is to find it.
bool is_unknown_gear(const Json& gear);

/// The readings of that table of a gear; none: it is not there, or has none.
///
/// Throws    SpecError
std::shared_ptr<const IdentifyProblem> read_measured(const Json* gear, const std::string& path);

}  // namespace gearwright
