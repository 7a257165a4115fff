// A spec and the gears that it describes.
#pragma once

#include <string_view>

#include "gearwright/arrange/arrange.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {

/// Warnings name keys as the file has them.
struct SolvedJob : Arranged {
  JobSpec spec;  ///< as read; what follows from it is in `completed`
};

/// Errors    keys with their table, "gear2.profile_shift"; as arrange()
Result<SolvedJob> solve(const JobSpec& spec, Scope scope);

/// "search", "identify" or "fit" if solve refuses the spec because numbers of it are yet to be
/// found; empty if the error is a fault. The error may be spelled already.
std::string_view finder_of(const JobSpec& spec, const Error& error);

}  // namespace gearwright
