// A spec and the gears that it describes.
#pragma once

#include <string_view>

#include "gearwright/arrange/arrange.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {

/// Warnings name the keys of the file.
struct SolvedJob : Arranged {
  JobSpec spec;  ///< as read; computed values are in `completed`
  /// The halves of double-helical gears, whose `gears` and `pair` are those of the half at z > 0.
  std::array<std::optional<Halves>, 2> halves{};
  /// The pinion with its rack, if gear 2 is one; then `gears` contains only the pinion.
  std::optional<RackPair> rack{};

  /// The number of gears, a rack included.
  int parts() const { return static_cast<int>(gears.size()) + (rack ? 1 : 0); }
};

/// Errors    keys with their table, "gear2.profile_shift"; as arrange(), halve() and halves_of();
///           `pair.shaft_angle` of double-helical gears on crossed axes; `gear2.form` of a rack, if
///           the scope is more than the gears
Result<SolvedJob> solve(const JobSpec& spec, Scope scope);

/// As solve(), and of a pinion with its rack too.
///
/// Errors    as solve() and mount_rack()
Result<SolvedJob> solve_any(const JobSpec& spec, Scope scope);

/// The error of a result that needs gears of one helix if the gears are double-helical.
std::optional<Error> one_helix_error(const SolvedJob& job);

/// "search", "identify" or "fit" if solve rejects the spec because its unknown numbers need that
/// verb; empty for other errors. The error may already contain keys of the file.
std::string_view finder_of(const JobSpec& spec, const Error& error);

}  // namespace gearwright
