// Adds the inch names of lengths to a JSON Schema written for mm. Internal to catalogue/ and job/.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace gearwright {

/// Adds, for each property that is a length, a property with the inch name and with the limits in
/// inch. If the property is required, one of the two names is sufficient. If an `enum` contains the
/// keys of lengths, their inch names are added to it.
void add_inch_names(nlohmann::ordered_json& schema);

/// Adds a rule to the schema of specs. According to this rule, the names of all lengths of a spec
/// must agree with the `units` of the spec.
void separate_units(nlohmann::ordered_json& schema);

}  // namespace gearwright
