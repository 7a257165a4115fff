// The answer of `load` in JSON and as a table for users. Internal to job/ and the
// program.
#pragma once

#include <string>

#include "gearwright/job/load_answer.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright {

/// A record with the title and "load".
Json load_json(const SolvedJob& job, const LoadAnalysis& answer);
std::string load_listing(const SolvedJob& job, const LoadAnalysis& answer);

}  // namespace gearwright
