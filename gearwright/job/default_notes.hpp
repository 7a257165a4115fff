// What a spec leaves out and is taken from elsewhere, in words: shifts that follow from the centre
// distance, keys of gear 2 that are gear 1's.
#pragma once

#include <optional>

#include "gearwright/spec/spec.hpp"

namespace gearwright {

/// One or both profile shifts are absent and follow from the given centre distance.
bool shifts_follow(const JobSpec& spec);

/// Says the shifts that were chosen; none: there are none, or they are 0. `cylindrical` has them.
std::optional<Warning> note_shifts(const JobSpec& spec);

/// Where `pair.choose_profile_shifts` is false: which are missing, and what they would be.
std::optional<Error> forbidden_shifts(const JobSpec& spec);

/// What gear 2 has from gear 1 and none of its numbers shows.
std::optional<Warning> note_inherited(const JobSpec& spec);

}  // namespace gearwright
