// Warns about samples of `scatter` that do not run well, and about tolerances that it does not vary.
#pragma once

#include "gearwright/job/solved_job.hpp"
#include "gearwright/scatter/scatter.hpp"

namespace gearwright {

/// Adds warnings about samples that jam, lose contact or often touch with an edge, and about a
/// tolerance of the centre distance that the bearings replace.
void warn_of_samples(const Scatter& scatter, SolvedJob& job);

}  // namespace gearwright
