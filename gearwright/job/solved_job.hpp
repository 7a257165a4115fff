// A spec and the gears that it describes.
#pragma once

#include <string_view>

#include "gearwright/arrange/arrange.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {

/// Warnings name keys as the file has them.
struct SolvedJob : Arranged {
  JobSpec spec;  ///< as read; what follows from it is in `completed`
  /// Of double-helical gears, where `gears` and `pair` are those of the half at z > 0.
  std::array<std::optional<Halves>, 2> halves{};
};

/// Errors    keys with their table, "gear2.profile_shift"; as arrange(); "gearN.double_helical" where
///           the scope is more than the gears
Result<SolvedJob> solve(const JobSpec& spec, Scope scope);

/// The mounted pair, of double-helical gears too.
///
/// Errors    as solve() of a pair, halve() and halves_of(); `pair.shaft_angle` of double-helical gears
///           on crossed axes
Result<SolvedJob> solve_pair(const JobSpec& spec);

/// "search", "identify" or "fit" if solve refuses the spec because numbers of it are yet to be
/// found; empty if the error is a fault. The error may be spelled already.
std::string_view finder_of(const JobSpec& spec, const Error& error);

}  // namespace gearwright
