// The contact part of the report: the result, patterns and maps, with names in words.
#pragma once

#include <optional>

#include "gearwright/job/contact_answer.hpp"
#include "gearwright/report/contact_report.hpp"

namespace gearwright {

/// An error with its value in the unit of its key. `index` counts the rows of error_entries().
NamedAmount named_error(std::size_t index, double value);

/// True if there is a pair and either the spec has [errors], [contact] or modifications, or the
/// teeth are circular arcs.
bool wants_contact(const SolvedJob& job);

/// A result and its part of the report. The report contains pointers into the job.
struct ContactPart {
  ContactAnswer answer;
  ContactReport report;
};

/// The contact part of a report, or nothing if the spec does not request it. If the result cannot
/// be computed, there is no part either, and the job gets a warning. The report needs equally
/// spaced positions over one pitch. If the spec gives other rotations, they apply to the result but
/// not to the report.
///
/// Errors    the errors of answer_contact: modifications that do not fit, an impossible lead
Result<std::optional<ContactPart>> contact_part(SolvedJob& job, Progress* progress = nullptr);

}  // namespace gearwright
