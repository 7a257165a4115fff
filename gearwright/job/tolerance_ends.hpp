// Tolerances of a spec: thickness allowances said in other ways, and the spec at both their ends.
// Internal to job/.
#pragma once

#include <functional>
#include <optional>

#include "gearwright/job/solved_job.hpp"

namespace gearwright {

using SolveAsGiven = std::function<Result<SolvedJob>(const JobSpec&, Scope)>;

/// The spec with allowances as numbers: of DIN 3967, of a span, of a dimension over balls.
///
/// Errors    `gearN.tolerance.…`: no such series; a reading that no tooth has; no tool to read it
Result<JobSpec> with_allowances(const JobSpec& given, const SolveAsGiven& solve);

/// The job at both ends; none: its spec has no tolerances.
///
/// Errors    as solve at that end; `pair.backlash`, where the tolerance of the centre distance alone
///           takes more; `pair.distance_tolerance`
Result<std::shared_ptr<const JobEnds>> solve_ends(const SolvedJob& job, Scope scope,
                                                  const SolveAsGiven& solve);

}  // namespace gearwright
