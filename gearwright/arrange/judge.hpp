// Judges arranged gears as drawn and at the ends of their tolerances.
//
// Every limit is judged as drawn and at every combination of the ends of the tolerances. If a
// finding is worse at a combination than as drawn, it names the combination. The contact analysis uses
// the gears at the mean of their tolerances. A remedy is a change of the input; the changed input is
// arranged and judged before the remedy is named.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "gearwright/arrange/arrange.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

/// Results computed in addition to the pair. All must outlive the call.
struct JudgedWith {
  const ContactResult* contact = nullptr;  ///< of the working flanks; null if not computed
  bool errors = false;                     ///< true if the contact includes errors of mounting
  std::optional<JudgedRating> rating{};    ///< none if not computed
  /// The contact of a changed pair under the same errors; it may add warnings. None if there is no
  /// contact. Without this function, findings about the contact have no remedy.
  std::function<std::optional<ContactResult>(Arranged&)> contact_again{};
};

/// The gears as drawn, or at one combination of the ends of their tolerances.
struct JudgedState {
  std::vector<Finding> findings;
  std::optional<RatedPair> pair;  ///< rated at this combination; none as drawn or without a rating
};

/// Judges the gears as drawn and then at every combination of the ends of their tolerances, until
/// `visit` returns false.
void visit_states(const Arranged& arranged, const JudgedWith& with,
                  const std::function<bool(const JudgedState&)>& visit);

/// All findings for the nominal values, and those that get worse at an end of the tolerances,
/// without remedies.
std::vector<Finding> findings_within_tolerances(const Arranged& arranged,
                                                const JudgedWith& with = {});

/// The verdict over the gears. Its messages name members of the input, such as `gear1.profile_shift`.
Verdict judge(const Arranged& arranged, const JudgedWith& with = {});

}  // namespace gearwright
