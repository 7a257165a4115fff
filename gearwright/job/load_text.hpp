// The answer of `load` in JSON, as a table for users and for spreadsheets. Internal to job/ and the
// program.
#pragma once

#include <string>

#include "gearwright/job/load_answer.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright {

/// {"load"}, under its title.
Json load_json(const SolvedJob& job, const LoadAnalysis& answer);
std::string load_listing(const SolvedJob& job, const LoadAnalysis& answer);

}  // namespace gearwright
