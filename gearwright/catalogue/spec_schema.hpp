// The JSON Schema (draft 2020-12) of specs, made from the key tables. Editors use it to complete
// TOML, and any validator can check a spec with it.
//
// The schema describes single keys and combinations of keys. Only the program can check geometric
// conditions.
#pragma once

#include <string>

namespace gearwright {

/// The text of the file, with two spaces per level and a line feed at the end.
std::string spec_schema();

}  // namespace gearwright
