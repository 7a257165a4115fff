// If a search has no feasible design, computes the smallest change of a single number that makes a
// design feasible.
//
// Each number is changed separately, by the least amount with which a design exists. Numbers that do
// not help at any value are omitted. There are two kinds of numbers:
//   limits          A change widens the region of every trial, and the smallest change over all trials
//                   is returned. Trials are evaluated in random order. Each trial is first evaluated
//                   slightly below the best change so far. Only a trial that is feasible there (about
//                   ln n of n trials) is bisected.
//   ratio, teeth    A change adds trials with the same limits, and the nearest feasible trial is used.
// For rated designs, the load, the face width and the steel are changed as well. Each trial is evaluated
// once or a few times, whereas a bisection of the whole search would evaluate it in every step.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/design/search.hpp"

namespace gearwright {

struct NearestChange {
  std::string field;  ///< the member of SearchProblem, such as "limits.contact_ratio", or
      ///< "rating.torque", "rating.power", or "gear1.material.name" for the steel of both gears
  std::string from;  ///< the given value, such as "1.2" or "[99, 101]"
  std::string to;    ///< value with which a design exists, rounded to the feasible side
  /// |to − from|, relative to the value itself (distance, ratio, teeth), to 1, or to 2 (sliding). The
  /// effort of `coprime` is 0.5. The effort of permitting interference is 100, because such designs do
  /// not run.
  double effort;
};

struct NearestChanges {
  std::vector<NearestChange> changes;  ///< by ascending effort
  /// Members for which not all trials were evaluated. A smaller change of such a member than the one in
  /// `changes` may be sufficient.
  std::vector<std::string> bounded;
  std::int64_t asked = 0;  ///< number of graphs computed
  bool stopped = false;    ///< true if the watch stopped the search, so that changes may be missing
  /// The rated design whose safety factors are nearest to the required ones.
  std::optional<DesignRow> safest;
};

/// The greatest number of trials that are evaluated repeatedly.
inline constexpr std::int64_t kMaxForChange = 2'000'000;
/// Greatest number of graphs computed for one member. The slowest kind of graph, with shortened tips,
/// takes 1 s for 2000.
inline constexpr std::int64_t kMaxChangeQuestions = 10'000;

/// The changes by ascending effort. The watch receives the number of trials.
///
/// Domain    no design is feasible; size() ≤ kMaxForChange (contract)
NearestChanges nearest_changes(const SearchProblem& problem, const SearchWatch& watch = {},
                               std::int64_t most_questions = kMaxChangeQuestions);

}  // namespace gearwright
