// Notes on the input: profile shifts that follow from the centre distance, overlapping flanks, and parts
// that were not read.
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

/// A note on the computed shifts in `cylindrical`; none if no shift is computed or all are 0.
std::optional<Warning> note_shifts(const GivenPair& given);

/// An error if `pair.choose_profile_shifts` is false and shifts are missing. The message gives the names
/// and possible values of these shifts.
std::optional<Error> forbidden_shifts(const GivenPair& given);

/// A note that the flanks of an internal pair on crossed axes overlap beside the line of action;
/// none if the lead crowning of `given` prevents this on the flanks of both directions.
std::optional<Warning> note_saddle(const GivenPair& given, const Pair& pair);

/// Adds those warnings of `found` that are not in `warnings` yet, with `before` in front of their messages.
void add_new(std::vector<Warning> found, std::vector<Warning>& warnings,
             std::string_view before = {});
inline constexpr std::string_view kSecondHalf = "Half at z < 0: ";

/// The warning that `what`, a key or a table, was not read.
Warning not_read(const std::string& what);

}  // namespace gearwright
