// Reads [gearN.measured] and the other data that are known about the gear.
// Internal to spec/.
#pragma once

#include <memory>
#include <string>

#include "gearwright/inspection/identify.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// True if the table of a gear gives a module, a base cylinder or a cutter.
bool has_module(const Json& gear);

/// True if the table of a gear has readings but no module, which `identify` has to find.
bool is_unknown_gear(const Json& gear);

/// The readings of gear 1 or 2, or null if its table is absent or has no readings. The number of
/// teeth of the mating gear is added to the readings of an unknown gear if the spec gives it and a
/// centre distance is known. If the readings have no centre distance, the distance of [pair] is
/// added too.
///
/// Throws    SpecError
std::shared_ptr<const IdentifyProblem> read_measured(const Json& tree, int which);

}  // namespace gearwright
