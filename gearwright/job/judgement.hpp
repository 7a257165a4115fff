// The verdict over a job: its gears, its pair, and what else was computed of it.
//
// As judge() of its gears (arrange/judge.hpp), with the keys as the file has them. Load is that of the
// job itself, at the mean of its tolerances.
#pragma once

#include <string>
#include <string_view>

#include "gearwright/job/rating_answer.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

/// What was computed beside the pair; null and false: it was not.
struct JudgedParts {
  const ContactResult* contact = nullptr;  ///< under the spec's errors
  const RatingAnswer* rating = nullptr;    ///< against the safeties that the spec wants
  bool load = false;                       ///< its findings are warnings of the job
};

/// The verdict; keys as a file has them.
Verdict judge(const SolvedJob& job, const JudgedParts& parts = {});

/// The last lines of a listing, of at most 100 bytes.
std::string verdict_listing(std::string_view level, std::string_view headline);
std::string verdict_listing(const Verdict& verdict);

}  // namespace gearwright
