// Notes on what an input leaves out: profile shifts that follow from the centre distance, parts of
// the input that were not read.
#pragma once

#include <optional>
#include <string>

#include "gearwright/arrange/given_pair.hpp"

namespace gearwright {

/// One or both profile shifts are absent and follow from the given centre distance.
bool shifts_follow(const GivenPair& given);

/// The shifts that were chosen; none: there are none, or they are 0. `cylindrical` has them.
std::optional<Warning> note_shifts(const GivenPair& given);

/// Where `pair.choose_profile_shifts` is false: which are missing, and what they would be.
std::optional<Error> forbidden_shifts(const GivenPair& given);

/// `what`: a key or a table.
Warning not_read(const std::string& what);

}  // namespace gearwright
