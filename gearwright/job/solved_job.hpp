// A spec and the gears that it describes.
#pragma once

#include <memory>
#include <mutex>
#include <string_view>
#include <vector>

#include "gearwright/arrange/arrange.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {

/// A spec with its gears and its pair. Warnings name the keys of the file.
struct SolvedJob : Arranged {
  JobSpec spec;  ///< spec as read; computed values are in `completed`
  /// The halves of double-helical gears. If they are present, `gears` and `pair` describe only the
  /// half at z > 0.
  std::array<std::optional<Halves>, 2> halves{};

  /// Returns the gears whose flanks are drawn. The second is null if gear 2 is a rack.
  std::array<const Gear*, 2> flanked_gears() const {
    return {&gears.front(), gears.size() > 1 ? &gears.back() : nullptr};
  }
  /// Returns arranged_corners() of the tolerances, computed at the first call. Copies of the job
  /// share the result.
  const std::vector<Arranged>& corners() const;

  struct Corners {
    std::mutex mutex{};
    std::optional<std::vector<Arranged>> list{};
  };
  std::shared_ptr<Corners> shared_corners = std::make_shared<Corners>();  ///< for corners()
};

/// Errors    a spec that describes a drive or has no gear 1; the errors of arrange(), halve() and
///           halves_of(), with the path of the key in the spec as the field, for example
///           "gear2.profile_shift"; `pair.shaft_angle` if double-helical gears have crossed axes;
///           `gear2.form` if gear 2 is a rack and `scope` includes more than the single gears
Result<SolvedJob> solve(const JobSpec& spec, Scope scope);

/// Works like solve(), but gear 2 may also be a rack, which is mounted with its pinion for every
/// `scope`.
Result<SolvedJob> solve_any(const JobSpec& spec, Scope scope);

/// If gear 2 is a rack, returns the error for a result that needs two gears. Otherwise, returns
/// none.
std::optional<Error> two_gears_error(const JobSpec& spec);

/// If a gear is double-helical, returns the error for a result that needs single-helical gears.
/// Otherwise, returns none.
std::optional<Error> one_helix_error(const SolvedJob& job);

/// Returns the verb that can compute missing numbers: "search", "identify" or "fit". `error` is
/// the error with which solve() has rejected the spec because of these numbers. For any other
/// error, the returned verb is empty. `error` may contain names of members or keys of the file.
std::string_view finder_of(const JobSpec& spec, const Error& error);

}  // namespace gearwright
