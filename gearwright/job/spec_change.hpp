// A change that the verdict tries, made in a spec as a user would make it.
// Internal to job/.
#pragma once

#include "gearwright/spec/spec.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

/// Sets the number; false: this spec gives it in another way, or leaves it to another gear.
bool make_change(JobSpec& spec, const SpecChange& change);

}  // namespace gearwright
