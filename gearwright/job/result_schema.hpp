// The JSON Schema (draft 2020-12) of results, made from the catalogue.
// Internal to job/ and the programs.
#pragma once

#include <vector>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// Every table of a result, each followed by the tables of its records.
std::vector<const QuantityTable*> result_tables();

/// The schema of the results of all verbs with --json, and of the error of a rejected spec.
Json result_schema();

}  // namespace gearwright
