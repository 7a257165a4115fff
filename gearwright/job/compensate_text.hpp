// The answer of `compensate` in JSON and as a table for users. Internal to job/ and the program.
#pragma once

#include <string>

#include "gearwright/catalogue/compensate_quantities.hpp"
#include "gearwright/job/compensate_answer.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright {

/// The quantities of a result as JSON, for all interfaces.
Json compensate_json(const SolvedJob& job, const CompensateAnswer& answer);
std::string compensate_listing(const SolvedJob& job, const CompensateAnswer& answer);

}  // namespace gearwright
