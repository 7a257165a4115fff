// The answer of `load` in JSON, as a table for people and for spreadsheets. Internal to job/ and the
// program.
#pragma once

#include "gearwright/verdict/verdict.hpp"

#include <string>

#include "gearwright/job/load_answer.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright {

Json load_json(const SolvedJob& job, const LoadAnalysis& answer, const Verdict& verdict);
std::string load_listing(const SolvedJob& job, const LoadAnalysis& answer);

}  // namespace gearwright
