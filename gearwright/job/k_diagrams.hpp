// The designs of all flanks that have modifications or a grade, for the page.
// Internal to job/.
#pragma once

#include <vector>

#include "gearwright/job/solved_job.hpp"
#include "gearwright/report/k_diagram.hpp"

namespace gearwright {

/// One per gear where both flanks are alike, else one per flank. What does not fit its flank is left
/// out: the verb contact says so.
std::vector<KDiagram> k_diagrams(const SolvedJob& job);

}  // namespace gearwright
