// A value of the catalogue as JSON, with the keys for JSON. Internal to job/ and the
// program.
#pragma once

#include "gearwright/catalogue/value.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// Numbers read back to the same double; null, NaN and infinity become null.
Json to_json(const Value& value);

/// A tree of JSON, a spec inside a result, as a value.
Value to_value(const Json& json);

}  // namespace gearwright
