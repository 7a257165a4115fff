// Adds the inch names of lengths to a JSON Schema that is written for mm. Internal to catalogue/
// and job/.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace gearwright {

/// For each property that is a length, adds a property with the inch name and with the limits in
/// inch. If the property is required, either of the two names is sufficient.
void add_inch_names(nlohmann::ordered_json& schema);

/// Adds a rule to the schema of specs. The names of all lengths of a spec must agree with its
/// `units`.
void separate_units(nlohmann::ordered_json& schema);

}  // namespace gearwright
