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

/// Pairs that a caller computes besides those of two gears of one helix.
struct OtherPairs {
  bool double_helical = false;
  bool rack = false;
};

/// The gears, and by its scope their pair: for double-helical gears that of one half, for a rack the
/// pinion with its rack.
///
/// Errors    keys with their table, "gear2.profile_shift"; as arrange(), halve(), halves_of() and
///           mount_rack(); `pair.shaft_angle` of double-helical gears on crossed axes; if the scope is
///           more than the gears, `gearN.double_helical` and `gear2.form` of pairs that are not among `also`
Result<SolvedJob> solve(const JobSpec& spec, Scope scope, OtherPairs also = {});

/// "search", "identify" or "fit" if solve rejects the spec because its unknown numbers need that
/// verb; empty for other errors. The error may already contain keys of the file.
std::string_view finder_of(const JobSpec& spec, const Error& error);

}  // namespace gearwright
