// Judges gears at their nominal values and at the ends of their tolerances.
//
// Each toleranced number has two ends, the least and the greatest permitted value. Every limit
// is checked for the nominal values and for every combination of ends. If a finding is worse at
// one of these combinations, the finding names the combination. The contact analysis uses the
// nominal gears, at the mean of their tolerances. A remedy is a change of the input. A remedy
// is proposed only after the changed input has been arranged and judged.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/arrange/arrange.hpp"
#include "gearwright/arrange/given_pair.hpp"
#include "gearwright/design/design_row.hpp"
#include "gearwright/drive/drive.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

/// Results that were computed in addition to the pair. All objects to which members point must
/// outlive the call.
struct JudgedWith {
  const ContactResult* contact = nullptr;  ///< contact of the working flanks; null if not computed
  bool errors = false;                     ///< true if errors of mounting are included in the
                                           ///< contact
  std::optional<PairRating> rating{};      ///< none if not computed
  /// Computes the contact of a changed pair with the same errors, and may add warnings. Returns
  /// none if there is no contact. If it is empty, findings about the contact have no remedy.
  std::function<std::optional<ContactResult>(Arranged&)> contact_again{};
};

/// The findings for the nominal gears, or for one combination of the ends of their tolerances.
struct JudgedState {
  std::vector<Finding> findings;
  std::optional<RatedPair> pair;  ///< inputs of the rating at this combination; none for the
                                  ///< nominal gears or without a rating
};

/// Returns all findings for the nominal values and for the combinations of the ends of the
/// tolerances. A finding with a worse level at a combination replaces the nominal finding. The
/// findings contain no remedies.
std::vector<Finding> findings_within_tolerances(const Arranged& arranged, const JudgedWith& with);

/// Makes a change that the verdict proposes, in the same way as the user would make it. Returns
/// false if the input gives the number in another form, or if a cutter or other data determine the
/// number. In this case, `given` must be discarded, because it may already be changed.
bool make_change(GivenPair& given, const SpecChange& change);

/// Returns the verdict on the gears. Messages name members of the input, such as
/// `gear1.profile_shift`.
///
/// Domain    a result of arrange(), so that `arranged.given` is not null (contract)
Verdict judge(const Arranged& arranged, const JudgedWith& with = {});

// Converts a design found by a search into the data of a drawing, and judges this drawing.
//
// A search computes nominal gears. The drawing adds the tolerances of tooth thickness and centre
// distance.

/// Returns the verdict on the drawing. If the search computes a rating, the verdict includes it.
/// The finding that the rating of plastics ignores wear is omitted, because it applies to every
/// design.
DrawnDesign judge_drawing(const SearchProblem& problem, const DesignRow& row);

/// Returns the worst finding that judge_drawing() does not omit, with the tolerance ends at which
/// it occurs and without a remedy. Returns none if the design runs, or if its drawing cannot be
/// rated.
///
/// Errors    those of arrange()
Result<std::optional<Finding>> finding_of_drawing(const SearchProblem& problem,
                                                  const DesignRow& row);

// Judges a drive. The level of the verdict is that of the worst finding of the meshes and the
// assembly. A remedy is tried on the whole drive before it is proposed.

struct DriveChange {
  Adjustable what;
  std::size_t index;  ///< index of the gear, or of the mesh if `what` is a centre distance
  double value;       ///< the new value, as in SpecChange
};

/// Returns the input with this change, or none if the input does not contain this number or a drive
/// cannot change it.
std::optional<DriveInput> changed(const DriveInput& input, const DriveChange& change);

/// Returns the verdict on the assembly and the meshes. A message about a mesh begins with the name
/// of the mesh. If planets can only be mounted axially, the finding is green, because axial
/// mounting is usual.
///
/// `wanted`  required safeties of a rated drive
/// `key_of`  returns the key of the changed number in the spec, for the text of the remedy; may be
///           empty
Verdict judge_drive(const Drive& drive, const DriveInput& input,
                    const std::function<std::string(const DriveChange&)>& key_of = {},
                    const Safeties& wanted = {1.0, 1.0});

/// Returns the level of the verdict of judge_drive(), without a search for remedies.
/// `unequal_spacing_counts` is false if the caller has requested unequally spaced planets. In this
/// case, unequal spacing is not a finding.
Level drive_level(const Drive& drive, const Safeties& wanted, bool unequal_spacing_counts);

}  // namespace gearwright
