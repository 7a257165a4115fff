// Which verb finds what a spec leaves open.
//
// Internal to job/ and the programs.
#pragma once

#include <string_view>

#include "gearwright/spec/spec.hpp"

namespace gearwright {

/// "search", "identify" or "fit" where solve refuses the spec because numbers of it are yet to be
/// found; empty: the error is a fault. The error may be spelled already.
std::string_view finder_of(const JobSpec& spec, const Error& error);

}  // namespace gearwright
