// What tolerances make of a record: the numbers that differ at their two ends, in JSON and for people.
// Internal to job/.
#pragma once

#include <vector>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// {key: [at lower, at upper]} of the numbers that differ, of every door (the allowance is the
/// page's), records inside as records, numbers of lists in their places (null: does not differ);
/// lists of records are left out.
Json interval_json(const ValueRecord& lower, const ValueRecord& upper);

/// Both ends as records for a listing, which shows the rows that differ alone.
std::vector<ValueRecord> differing(ValueRecord lower, ValueRecord upper);

}  // namespace gearwright
