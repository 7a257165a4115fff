// The K-diagrams of all flanks that have modifications or an accuracy grade, for the page.
// Internal to job/.
#pragma once

#include <vector>

#include "gearwright/job/solved_job.hpp"
#include "gearwright/report/k_diagram.hpp"

namespace gearwright {

/// One diagram for each gear if both flanks are equal, otherwise one for each flank. A modification
/// that does not fit its flank is omitted, because the verb contact reports it.
std::vector<KDiagram> k_diagrams(const SolvedJob& job);

}  // namespace gearwright
