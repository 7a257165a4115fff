// The answers of `contact`, `compensate` and `load` in JSON and as tables for people.
// Internal to job/ and the program.
#pragma once

#include <string>

#include "gearwright/job/compensate_answer.hpp"
#include "gearwright/job/contact_answer.hpp"
#include "gearwright/job/load_answer.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// The quantities of the result.
ValueRecord contact_record(const SolvedJob& job, const ContactAnswer& answer);
/// A record with the title and "contact".
Json contact_json(const SolvedJob& job, const ContactAnswer& answer);
std::string contact_listing(const SolvedJob& job, const ContactAnswer& answer);

/// The quantities of a result as JSON, for all interfaces.
Json compensate_json(const SolvedJob& job, const CompensateAnswer& answer);
std::string compensate_listing(const SolvedJob& job, const CompensateAnswer& answer);

/// A record with the title of the spec and, under the key "load", the results under load.
Json load_json(const SolvedJob& job, const LoadAnalysis& answer);
std::string load_listing(const SolvedJob& job, const LoadAnalysis& answer);

}  // namespace gearwright
