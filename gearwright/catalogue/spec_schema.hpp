// Makes the JSON Schema (draft 2020-12) of specs from the key tables. Editors use the schema to
// complete TOML, and any validator can check a spec with it.
//
// The schema describes single keys and combinations of keys. It cannot describe geometric
// conditions, which only the program checks.
#pragma once

#include <string>

namespace gearwright {

/// Returns the text of the file, with two spaces per level and a line feed at the end.
std::string spec_schema();

}  // namespace gearwright
