// The text of a spec as a tree of tables.
//
// Internal to spec/.
#pragma once

#include <string_view>

#include "gearwright/spec/json.hpp"
#include "gearwright/spec/spec_text.hpp"

namespace gearwright {

/// The tree of a spec, members in their order. Nesting is bounded, and every key of a table stands
/// there once, in JSON too.
///
/// Errors    what is wrong, with line and column
Result<Json> parse_spec(std::string_view text, SpecFormat format);

}  // namespace gearwright
