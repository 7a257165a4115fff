// Judges gears at their nominal values and at the ends of their tolerances.
//
// Every limit is checked for the nominal values and for every combination of the ends of the
// tolerances. If a finding is worse at one of these combinations, the finding names it. The contact
// analysis uses the nominal gears, at the mean of their tolerances. A remedy is a change of the
// input. A remedy is proposed only after the changed input has been arranged and judged.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "gearwright/arrange/arrange.hpp"
#include "gearwright/arrange/given_pair.hpp"
#include "gearwright/design/design_row.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

/// Results that were computed in addition to the pair. All objects to which members point must
/// outlive the call.
struct JudgedWith {
  const ContactResult* contact = nullptr;  ///< contact of the working flanks; null if not computed
  bool errors = false;                     ///< true if errors of mounting are included in the
                                           ///< contact
  std::optional<JudgedRating> rating{};    ///< none if not computed
  /// Computes the contact of a changed pair with the same errors, and may add warnings. Returns
  /// none if there is no contact. If this function is empty, findings about the contact have no
  /// remedy.
  std::function<std::optional<ContactResult>(Arranged&)> contact_again{};
};

/// The findings for the nominal gears, or for one combination of the ends of their tolerances.
struct JudgedState {
  std::vector<Finding> findings;
  std::optional<RatedPair> pair;  ///< inputs of the rating at this combination; none for the
                                  ///< nominal gears or without a rating
};

/// All findings for the nominal values, and all findings that are worse at a combination of the
/// ends of the tolerances. The findings have no remedies.
std::vector<Finding> findings_within_tolerances(const Arranged& arranged,
                                                const JudgedWith& with = {});

/// The verdict on the gears. Messages name members of the input, such as `gear1.profile_shift`.
Verdict judge(const Arranged& arranged, const JudgedWith& with = {});

// Converts a design that a search has found into the data of a drawing, and judges this drawing.
//
// A search computes nominal gears. The drawing adds the tolerances of tooth thickness and centre
// distance. The verdict covers the nominal pair and all ends of these tolerances.

/// The verdict on the drawing. If the search computes a rating, the verdict includes it. The
/// finding that the rating of plastics ignores wear is omitted, because it applies to every design.
DrawnDesign judge_drawing(const SearchProblem& problem, const DesignRow& row);

}  // namespace gearwright
