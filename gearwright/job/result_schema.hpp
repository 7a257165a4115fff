// The JSON Schema (draft 2020-12) of results, made from the catalogue.
// Internal to job/ and the program.
#pragma once

#include "gearwright/spec/json.hpp"

namespace gearwright {

/// Of every answer of every verb with --json, and of what a refused spec prints.
Json result_schema();

}  // namespace gearwright
