// Reads [gearN.measured], and the other known data of the gear.
// Internal to spec/.
#pragma once

#include <memory>
#include <string>

#include "gearwright/inspection/identify.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// True if the table of a gear gives a module, a base cylinder or a cutter.
bool has_module(const Json& gear);

/// True for a table of a gear with readings and without a module, which identify has to find.
bool is_unknown_gear(const Json& gear);

/// The readings of gear 1 or 2; none if its table is absent or has no readings. Those of an unknown
/// gear contain the number of teeth of its mating gear and the centre distance of [pair], if both are
/// given there and not among the readings.
///
/// Throws    SpecError
std::shared_ptr<const IdentifyProblem> read_measured(const Json& tree, int which);

}  // namespace gearwright
