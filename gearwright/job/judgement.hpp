// Computes the verdict on the gears, the pair and other results of a job.
//
// The verdict is computed in the same way as by judge() for arranged gears (arrange/judge.hpp), but
// its messages name the keys of the file. Results under load are computed once, at the mean of the
// tolerances.
#pragma once

#include <string>
#include <string_view>

#include "gearwright/catalogue/rating_quantities.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

/// The results that are judged in addition to the gears and the pair. A result that was not
/// computed is null or false.
struct JudgedParts {
  const ContactResult* contact = nullptr;  ///< under the errors of the spec
  const RatingAnswer* rating = nullptr;    ///< with the required safety factors of the spec
  bool load = false;  ///< true if contact under load has been computed; its findings are warnings
                      ///< of the job
};

Verdict judge(const SolvedJob& job, const JudgedParts& parts = {});

/// Returns the verdict as the last lines of a listing, for a terminal of 80 columns.
std::string verdict_listing(std::string_view level, std::string_view headline);
std::string verdict_listing(const Verdict& verdict, UnitSystem units);

}  // namespace gearwright
