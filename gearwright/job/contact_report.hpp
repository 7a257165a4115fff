// What the report tells about contact: the answer, patterns and maps, with names in plain words.
#pragma once

#include <optional>

#include "gearwright/job/contact_answer.hpp"
#include "gearwright/report/contact_report.hpp"

namespace gearwright {

/// An error by its place in error_entries(), its value in the unit of its key.
NamedAmount named_error(std::size_t index, double value);

/// The spec has [errors], [contact] or modifications, or its pair is one of circular arcs; and there
/// is a pair to turn.
bool wants_contact(const SolvedJob& job);

/// An answer and the part of the report about it. The report points into the job.
struct ContactPart {
  ContactAnswer answer;
  ContactReport report;
};

/// None where the spec asks nothing of it, and where there is nothing to tell: then a warning in
/// the job says why. A contract of the report needs equal positions over one pitch: where the
/// spec has other rotations, those are the answer's, and a pitch of its own the report's.
///
/// Errors    as answer_contact: modifications that do not fit, a lead that cannot be
Result<std::optional<ContactPart>> contact_part(SolvedJob& job, Progress* progress = nullptr);

}  // namespace gearwright
