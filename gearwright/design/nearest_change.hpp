// The smallest change of one number that makes designs feasible if there are none.
//
// Each limit is loosened by itself, to the least change after which a design exists; limits that do
// not help however far they go are not named. Two kinds of numbers:
//   limits          keep the trials and widen what each is left: the least change is the least that
//                   any one trial needs. Trials come in a random order; one that is not feasible a
//                   step nearer than the best so far costs that one question, and only a new best,
//                   ln n of n trials, is bisected.
//   ratio, teeth    bring new trials, whose limits are the same: the nearest feasible one
// Of rated designs load, face width and steel are such numbers too.
// Both ask a trial once or a few times, not once in every step of a bisection of the whole search.
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
  double effort;  ///< they are ordered by it
};

struct NearestChanges {
  std::vector<NearestChange> changes;  ///< smallest first
  /// Members whose trials were not all evaluated. A named change of them makes a design feasible,
  /// but a smaller one may also do so.
  std::vector<std::string> bounded;
  std::int64_t asked = 0;  ///< trials whose graph was computed, a few times each
  bool stopped = false;    ///< by the watch: what was found until then
  /// The rated design that comes nearest to the required safety factors.
  std::optional<DesignRow> safest;
};

/// The greatest number of trials that are evaluated repeatedly.
inline constexpr std::int64_t kMaxForChange = 2'000'000;
/// Questions to graphs for one limit. The slowest kind, shortened tips, answers some 2000 a second.
inline constexpr std::int64_t kMaxChangeQuestions = 10'000;

/// The changes, smallest first. The watch receives the number of trials.
///
/// Domain    nothing is feasible; size() ≤ kMaxForChange (contract)
NearestChanges nearest_changes(const SearchProblem& problem, const SearchWatch& watch = {},
                               std::int64_t most_questions = kMaxChangeQuestions);

}  // namespace gearwright
