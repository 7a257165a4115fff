// A spec as TOML text, from its tree.
// Internal to spec/ and the program.
#pragma once

#include <string>
#include <vector>

#include "gearwright/spec/json.hpp"

namespace gearwright {

/// A value on one line. A table is written in braces.
std::string toml_value(const Json& value);

/// The tree as TOML text. Reading the text gives the same doubles. Plain values precede tables, and
/// each table of a list has a heading [[name]].
///
/// Domain    an object of numbers, strings, booleans, arrays and objects (contract)
std::string toml_text(const Json& tree);

/// Sentences as comments. Each sentence begins on a new line.
std::string toml_comment(const std::vector<std::string>& sentences);

}  // namespace gearwright
