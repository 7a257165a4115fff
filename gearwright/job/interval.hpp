// The range of a record within tolerances: the numbers that differ at the two ends, in JSON and for
// users. Internal to job/.
#pragma once

#include <vector>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// {key: [at lower, at upper]} of the numbers that differ, for all interfaces (the allowance is for
/// the page only). Inner records are records. In lists, the place of a number that does not differ
/// contains null. Lists of records are omitted.
Json interval_json(const ValueRecord& lower, const ValueRecord& upper);

/// Both ends as records for a listing, which shows only the rows that differ.
std::vector<ValueRecord> differing(ValueRecord lower, ValueRecord upper);

}  // namespace gearwright
