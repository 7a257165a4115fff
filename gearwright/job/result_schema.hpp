// The JSON Schema (draft 2020-12) of results, made from the catalogue.
// Internal to job/ and the programs.
#pragma once

#include <vector>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// Every table of a result. Each is followed by the tables of the records that it contains.
std::vector<const QuantityTable*> result_tables();

/// The schema of the results of all verbs with --json, including the error of a rejected spec.
Json result_schema();

}  // namespace gearwright
