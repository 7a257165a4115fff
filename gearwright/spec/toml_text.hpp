// A spec as TOML text, from its tree.
// Internal to spec/ and the program.
#pragma once

#include <string>
#include <vector>

#include "gearwright/spec/json.hpp"

namespace gearwright {

/// A value on one line; a table in braces.
std::string toml_value(const Json& value);

/// Numbers read back to the same double. Plain values precede tables, and lists of tables have a
/// heading [[name]] for each table.
///
/// Domain    an object of numbers, strings, booleans, arrays and objects (contract)
std::string toml_text(const Json& tree);

/// Sentences as comments, each on lines of its own.
std::string toml_comment(const std::vector<std::string>& sentences);

}  // namespace gearwright
