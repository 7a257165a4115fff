// A spec and the gears that it describes.
#pragma once

#include "gearwright/arrange/arrange.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {

/// Warnings name keys as the file has them.
struct SolvedJob : Arranged {
  JobSpec spec;  ///< as read; what follows from it is in `completed`
};

/// Errors    keys with their table, "gear2.profile_shift"; as arrange()
Result<SolvedJob> solve(const JobSpec& spec, Scope scope);

}  // namespace gearwright
