// A rating for users and as JSON (as CSV in job/csv_answer.hpp). Internal to job/ and the program.
#pragma once

#include <string>

#include "gearwright/job/rating_answer.hpp"
#include "gearwright/spec/json.hpp"
namespace gearwright {

/// {"rating"}, under its title.
Json rating_json(const SolvedJob& job, const RatingAnswer& answer);
/// Inputs, factors, safeties: symbol, value, unit, clause of the standard, branch.
std::string rating_listing(const SolvedJob& job, const RatingAnswer& answer);

}  // namespace gearwright
