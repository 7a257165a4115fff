// Computes, for a search without a feasible design, the smallest change of a single number with
// which a design is feasible.
//
// Each number is changed separately, by the smallest amount with which a design exists. Numbers
// that do not help at any value are omitted. There are two kinds of numbers:
//   limits          A change widens the region of every trial. The result is the smallest change
//                   over all trials. The trials are evaluated in random order. Each trial is first
//                   evaluated with a change slightly smaller than the smallest one found so far.
//                   If the trial is then feasible, which is true for about ln n of n trials,
//                   bisection finds the smallest change for this trial.
//   ratio, teeth    A change adds trials but keeps the limits. The nearest feasible trial is used.
//
// For rated designs, the load, the face width and the steel are changed as well.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/design/search.hpp"

namespace gearwright {

struct NearestChange {
  std::string field;  ///< the member of SearchProblem, such as "limits.contact_ratio"; or
      ///< "rating.torque", "rating.power", or "gear1.material.name" for the steel of both gears
  std::string from;  ///< the given value, such as "1.2" or "[99, 101]"
  std::string to;    ///< value with which a design exists, rounded towards feasible values
  /// Size of the change: |to − from| divided by the value itself (distance, ratio, teeth, load,
  /// face width), by 2 (sliding) or by 1 (others). The effort of `coprime` and of another steel
  /// is 0.5. The effort of permitting interference is 100, because designs with interference do
  /// not run.
  double effort;
};

struct NearestChanges {
  std::vector<NearestChange> changes;  ///< by ascending effort
  /// Members for which not all trials were evaluated. A change smaller than the one in
  /// `changes` may be sufficient for such a member.
  std::vector<std::string> bounded;
  std::vector<std::string> tried;  ///< all members that were changed, with or without success
  std::int64_t asked = 0;          ///< number of graphs computed
  bool stopped = false;  ///< true if the watch stopped the search; changes may then be missing
  /// The rated design whose safety factors come nearest to the required ones.
  std::optional<DesignRow> safest;
};

/// Greatest number of trials of a search for which changes are computed. The number is limited,
/// because each trial is evaluated several times for every member.
inline constexpr std::int64_t kMaxForChange = 2'000'000;
/// Greatest number of graphs computed for one member. The slowest graphs are those with shortened
/// tips, of which 2000 take 1 s.
inline constexpr std::int64_t kMaxChangeQuestions = 10'000;

/// Returns the changes by ascending effort. The watch receives the number of evaluations of trials.
///
/// Domain    no design is feasible; size() ≤ kMaxForChange (contract)
NearestChanges nearest_changes(const SearchProblem& problem, const SearchWatch& watch = {},
                               std::int64_t most_questions = kMaxChangeQuestions);

}  // namespace gearwright
