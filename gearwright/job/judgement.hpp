// The verdict over a job: its gears, its pair, and the contact that was asked for.
#pragma once

#include <string>
#include <string_view>

#include "gearwright/job/rating_answer.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

/// `contact`: under the spec's errors; `rating`: against the safeties that the spec wants; null
/// where nobody asked. Keys as a file has them.
Verdict judge(const SolvedJob& job, const ContactResult* contact = nullptr,
              const RatingAnswer* rating = nullptr);

/// The last lines of a listing, of at most 100 bytes.
std::string verdict_listing(std::string_view level, std::string_view headline);
std::string verdict_listing(const Verdict& verdict);

}  // namespace gearwright
