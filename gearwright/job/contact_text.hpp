// The answer of `contact` in JSON and as a table for users. Internal to job/ and the program.
#pragma once

#include <string>

#include "gearwright/catalogue/value.hpp"
#include "gearwright/job/contact_answer.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright {

/// The quantities of the result.
ValueRecord contact_record(const SolvedJob& job, const ContactAnswer& answer);
/// A record with the title and "contact".
Json contact_json(const SolvedJob& job, const ContactAnswer& answer);
std::string contact_listing(const SolvedJob& job, const ContactAnswer& answer);

}  // namespace gearwright
