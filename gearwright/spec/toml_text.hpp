// A spec as TOML text, from its tree.
// Internal to spec/ and the program.
#pragma once

#include <string>

#include "gearwright/spec/json.hpp"

namespace gearwright {

/// Numbers read back to the same double. Plain values precede tables.
///
/// Domain    an object of numbers, strings, booleans, arrays and objects (contract)
std::string toml_text(const Json& tree);

}  // namespace gearwright
