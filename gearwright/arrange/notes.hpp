// Notes on absent or unsupported parts of an input: profile shifts that follow from the centre
// distance, parts of the input that were not read.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/arrange/given_pair.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// True if one or both profile shifts are absent and follow from the given centre distance.
bool shifts_follow(const GivenPair& given);

/// A note on the computed shifts; none if there are none or all are 0. `cylindrical` contains them.
std::optional<Warning> note_shifts(const GivenPair& given);

/// An error if `pair.choose_profile_shifts` is false and shifts are missing, with their names and
/// possible values.
std::optional<Error> forbidden_shifts(const GivenPair& given);

/// A note that the flanks of an internal pair on crossed axes overlap beside the line of action;
/// none if the lead crowning of `given` prevents this on the flanks of both directions.
std::optional<Warning> note_saddle(const GivenPair& given, const Pair& pair);

/// Adds the warnings that are not there yet, their messages after `before`.
void add_new(std::vector<Warning> found, std::vector<Warning>& warnings,
             std::string_view before = {});
inline constexpr std::string_view kSecondHalf = "Half at z < 0: ";

/// `what` is a key or a table.
Warning not_read(const std::string& what);

}  // namespace gearwright
