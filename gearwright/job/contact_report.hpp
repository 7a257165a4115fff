// The contact part of the report: the result, patterns and maps, with names in words.
#pragma once

#include <optional>

#include "gearwright/job/contact_answer.hpp"
#include "gearwright/report/contact_report.hpp"

namespace gearwright {

/// An error by its index in error_entries(), with its value in the unit of its key.
NamedAmount named_error(std::size_t index, double value);

/// True if the spec has [errors], [contact] or modifications, or if its pair is one of circular
/// arcs, and if there is a pair.
bool wants_contact(const SolvedJob& job);

/// A result and its part of the report. The report points into the job.
struct ContactPart {
  ContactAnswer answer;
  ContactReport report;
};

/// The contact part of a report. None if the spec does not request it, and none with a warning in
/// the job if there is no result. The report requires equal positions over one pitch, so if the
/// spec has other rotations, only the result has those.
///
/// Errors    as answer_contact: modifications that do not fit, a lead that cannot be
Result<std::optional<ContactPart>> contact_part(SolvedJob& job, Progress* progress = nullptr);

}  // namespace gearwright
