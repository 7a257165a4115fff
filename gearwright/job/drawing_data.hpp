// The table of data of a workshop drawing, as ISO 21771 and DIN 3966-1 require, from the
// catalogue's records. Internal to job/.
#pragma once

#include <vector>

#include "gearwright/cad/gear_sheet.hpp"
#include "gearwright/job/solved_job.hpp"

namespace gearwright {

/// Teeth, diameters, tooth thickness with its limits, flank modifications, tolerances with a grade,
/// mating gear. Missing values are omitted. `which`: 1 or 2.
std::vector<DataGroup> drawing_data(const SolvedJob& job, int which);

}  // namespace gearwright
