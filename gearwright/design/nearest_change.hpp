// For a search without a feasible design, computes changes of single numbers after which a design
// is feasible.
//
// Each number is changed separately, by the smallest amount with which a design exists. A number is
// omitted if no value of it gives a design. There are two kinds of numbers:
//   limits          A change widens the region of every trial. The result is the smallest change
//                   over all trials. The trials are evaluated in random order. Each trial is first
//                   evaluated with a change slightly smaller than the smallest one found so far.
//                   If the trial is then feasible, bisection finds the smallest change for this
//                   trial. This happens for about ln n of n trials.
//   ratio, teeth    A change adds trials but keeps the limits. The nearest feasible trial is used.
//
// For rated designs, the load, the face width and the steel are also changed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/design/search.hpp"

namespace gearwright {

struct NearestChange {
  /// The changed member of SearchProblem, such as "limits.contact_ratio". Other values are
  /// "rating.torque", "rating.output_torque", "rating.power", and "gear1.material.name" for the steel
  /// of both gears.
  std::string field;
  std::string from;  ///< the given value, such as "1.2" or "[99, 101]"
  std::string to;    ///< value with which a design exists, rounded to the feasible side
  /// Size of the change: |to − from| divided by the given value (distance, ratio, teeth, load, face
  /// width), by 2 (sliding) or by 1 (other numbers). `coprime` and another steel have the effort
  /// 0.5. Permitting interference has the effort 100, because designs with interference do not run.
  double effort;
};

struct NearestChanges {
  std::vector<NearestChange> changes;  ///< by ascending effort
  /// Members for which not all trials were evaluated. A smaller change than the one in `changes`
  /// may be sufficient for such a member.
  std::vector<std::string> bounded;
  std::vector<std::string> tried;  ///< all members that were changed, with or without success
  std::int64_t asked = 0;          ///< number of graphs computed
  bool stopped = false;  ///< true if the watch stopped the search; changes may then be missing
  /// The rated design with the greatest safety factors, compared with the required ones.
  std::optional<DesignRow> safest;
};

/// Changes are computed only if the search has at most this number of trials. Each trial is
/// evaluated several times for every member.
inline constexpr std::int64_t kMaxForChange = 2'000'000;
/// Greatest number of graphs computed for one member. The slowest graphs are those with shortened
/// tips; 2000 of them take 1 s.
inline constexpr std::int64_t kMaxChangeQuestions = 10'000;

/// Returns the changes by ascending effort. `watch` receives the number of evaluated trials.
///
/// Domain    no design is feasible; size() ≤ kMaxForChange (contract)
NearestChanges nearest_changes(const SearchProblem& problem, const SearchWatch& watch = {},
                               std::int64_t most_questions = kMaxChangeQuestions);

}  // namespace gearwright
