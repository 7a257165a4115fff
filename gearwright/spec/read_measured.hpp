// Reads [gearN.measured] and the other data that are known about the gear.
// Internal to spec/.
#pragma once

#include <memory>

#include "gearwright/inspection/identify.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// True if the table of a gear gives a module, a base cylinder or a cutter.
bool has_module(const Json& gear);

/// True if the table of a gear has readings but no module, which `identify` has to find.
bool is_unknown_gear(const Json& gear);

/// The readings of gear 1 or 2, or null if its table is absent or has no readings. The number of teeth
/// of the mating gear and the centre distance of [pair] are added to the readings of an unknown gear,
/// if both are given there and not among the readings.
///
/// Throws    SpecError
std::shared_ptr<const IdentifyProblem> read_measured(const Json& tree, int which);

}  // namespace gearwright
