// The verdict over arranged gears, as drawn and at the ends of their tolerances.
//
// Every limit is judged as drawn and at every combination of the ends of the tolerances. If a
// finding is worse at a combination than as drawn, it names the combination. Contact is that of the
// gears themselves, at the mean of their tolerances. Remedies are changes of the input that are
// arranged and judged before they are named.
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
  bool errors = false;                     ///< true if the contact is under errors
  std::optional<JudgedRating> rating{};    ///< none if not computed
  /// The contact of a changed pair under the same errors; it may add warnings. None if there is no
  /// contact. Without this function, findings about the contact have no remedy.
  std::function<std::optional<ContactResult>(Arranged&)> contact_again{};
};

/// The gears as drawn, or at one combination of the ends of their tolerances.
struct JudgedState {
  std::vector<Finding> findings;
  std::optional<RatedPair> pair;  ///< of the rating at ends; none if the standard does not cover it
};

/// Judges the gears as drawn and then at every combination of the ends of their tolerances, until
/// `visit` returns false.
void visit_states(const Arranged& arranged, const JudgedWith& with,
                  const std::function<bool(const JudgedState&)>& visit);

/// All findings for the nominal values, and those that get worse at an end of the tolerances,
/// without remedies.
std::vector<Finding> findings_within_tolerances(const Arranged& arranged,
                                                const JudgedWith& with = {});

/// Messages name members of the input, "`gear1.profile_shift`".
Verdict judge(const Arranged& arranged, const JudgedWith& with = {});

}  // namespace gearwright
