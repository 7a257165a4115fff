// The JSON Schema (draft 2020-12) of results, made from the catalogue.
// Internal to job/ and the programs.
#pragma once

#include <vector>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// Every table of a result, each followed by those of the records in it.
std::vector<const QuantityTable*> result_tables();

/// Of every answer of every verb with --json, and of what a refused spec prints.
Json result_schema();

}  // namespace gearwright
