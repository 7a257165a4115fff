// The range of a record within tolerances: the numbers that differ between the two ends, in JSON
// and for users. Internal to job/.
#pragma once

#include <vector>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// {key: [at lower, at upper]} for the numbers that differ. It contains the quantities of all
/// interfaces, also the thickness allowance, which otherwise appears on the page only. An inner
/// record becomes a record. In a list, null replaces a number that does not differ. Lists of
/// records are omitted.
Json interval_json(const ValueRecord& lower, const ValueRecord& upper);

/// Both ends as records for a listing. The listing shows only the rows that differ.
std::vector<ValueRecord> differing(ValueRecord lower, ValueRecord upper);

}  // namespace gearwright
