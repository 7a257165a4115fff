// The smallest change of one number that makes designs feasible if there are none.
//
// Each limit is loosened separately, by the least change after which a design exists. Limits that
// do not help at any value are not named. There are two kinds of numbers:
//   limits          keep the trials and widen the region of each: the least change is the least of
//                   all trials. Trials are evaluated in a random order. A trial that is not
//                   feasible slightly below the best change so far needs one evaluation, and only a
//                   new best, ln n of n trials, is bisected.
//   ratio, teeth    add trials with the same limits: the nearest feasible one is used
// For rated designs, load, face width and steel are such numbers too. A trial is evaluated once or
// a few times, not once in every step of a bisection of the whole search.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/design/search.hpp"

namespace gearwright {

struct NearestChange {
  std::string field;  ///< the member of SearchProblem, "limits.contact_ratio"; beside it
      ///< "rating.torque", "rating.power", and of both gears `gear1`'s `material.name`
  std::string from;  ///< as given, "1.2" or "[99, 101]"
  std::string to;    ///< value with which a design exists, rounded to the feasible side
  /// |to − from| in units of the value itself (distance, ratio, teeth), of 1, or of 2 (sliding);
  /// `coprime` counts 0.5, and to allow interference, whose designs do not run, 100.
  double effort;  ///< by which they are ordered
};

struct NearestChanges {
  std::vector<NearestChange> changes;  ///< smallest first
  /// Members whose trials were not all evaluated. A named change of them makes a design feasible,
  /// but a smaller one may also do so.
  std::vector<std::string> bounded;
  std::int64_t asked = 0;  ///< trials whose graph was computed, a few times each
  bool stopped = false;    ///< true if the watch stopped the search; the changes are those found so
                           ///< far
  /// The rated design that comes nearest to the required safety factors.
  std::optional<DesignRow> safest;
};

/// The greatest number of trials that are evaluated repeatedly.
inline constexpr std::int64_t kMaxForChange = 2'000'000;
/// Limit of graph evaluations for one limit. The slowest kind, shortened tips, takes 1 s for 2000.
inline constexpr std::int64_t kMaxChangeQuestions = 10'000;

/// The changes, smallest first. The watch receives the number of trials.
///
/// Domain    nothing is feasible; size() ≤ kMaxForChange (contract)
NearestChanges nearest_changes(const SearchProblem& problem, const SearchWatch& watch = {},
                               std::int64_t most_questions = kMaxChangeQuestions);

}  // namespace gearwright
