// The answer of `contact` in JSON and as a table for people. Internal to job/ and the program.
#pragma once

#include "gearwright/verdict/verdict.hpp"

#include <string>

#include "gearwright/catalogue/value.hpp"
#include "gearwright/job/contact_answer.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright {

/// What the catalogue says of it.
ValueRecord contact_record(const SolvedJob& job, const ContactAnswer& answer);
Json contact_json(const SolvedJob& job, const ContactAnswer& answer, const Verdict& verdict);
std::string contact_listing(const SolvedJob& job, const ContactAnswer& answer);

}  // namespace gearwright
