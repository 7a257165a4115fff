// The JSON Schema (draft 2020-12) of specs, made from the key tables: what editors complete TOML
// from, and what any validator checks a spec against before it is sent.
//
// It says what can be said of one key or of keys beside each other; what follows from geometry only
// the program knows.
#pragma once

#include <string>

namespace gearwright {

/// As a file: two spaces a level, a line feed at the end.
std::string spec_schema();

}  // namespace gearwright
