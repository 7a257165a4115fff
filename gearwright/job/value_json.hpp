// Converts a value of the catalogue to JSON, with the keys for JSON, and back. Internal to job/ and
// the program.
#pragma once

#include "gearwright/catalogue/value.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// Reading the JSON gives the same doubles. An absent value, NaN and infinity become null.
Json to_json(const Value& value);

/// A tree of JSON as a value, for example a spec inside a result.
Value to_value(const Json& json);

}  // namespace gearwright
