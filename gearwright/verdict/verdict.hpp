// Judges whether the gears work. If they do not, the verdict gives the reason and a remedy.
//
// One verdict covers all results of a job: the warnings of gears, pair and contact, the margins of
// the clearances, the position of the contact under the errors, and the safety factors. The worst
// finding comes first, and the headline states it in words. The command line, JSON, Python and the
// page show the same verdict.
//
// Findings are computed for the nominal values, or for every combination of tolerance ends. In the
// second case, findings of the same kind are merged, and the worst finding is kept. verdict_of adds
// remedies that were tried (remedy.hpp) and the headline.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gearwright/contact/contact.hpp"
#include "gearwright/pair/pair.hpp"
#include "gearwright/pair/rack_pair.hpp"
#include "gearwright/rating/sizing.hpp"

namespace gearwright {

enum class Level {
  green,  ///< the gears run, and nothing needs attention
  amber,  ///< the gears run, but the user should check the findings
  red,    ///< the gears cannot be made or do not run as specified
};
const char* to_string(Level level);
/// Returns red for a problem, amber for a caution, and green for a note.
Level level_of(Severity severity);

/// Returns, for example, "ISO/TR 10064-2 recommends at least 0.100 mm".
std::string recommendation(double recommended_backlash);

struct FindingValue {
  std::string name;
  double value;
  bool length;  ///< true for a length in mm, false for a pure number
};

/// The numbers of a spec that a remedy can change.
enum class Adjustable {
  profile_shift,        ///< x
  tip_diameter,         ///< d_a   mm
  thickness_allowance,  ///< E_sn  mm
  teeth,                ///< z
  helix_angle,          ///< β     degrees
  face_width,           ///< b     mm
  bore,                 ///< mm, diameter
  lead_crowning,        ///< C_β   µm, both flanks
  lead_slope,           ///< C_Hβ  µm, both flanks
  center_distance,      ///< a     mm, of the pair
};

struct SpecChange {
  Adjustable what;
  int gear;  ///< 1, 2; 0 for the pair or both gears
  double value;
  std::string path{};  ///< key of the changed number in the spec of a drive; otherwise empty
};

struct Finding {
  WarningCode code;  ///< code of a warning or of a margin (form_margin, fillet_margin, tip_margin,
                     ///< edge_contact, contact_place, no_backlash, root_safety, flank_safety,
                     ///< spectrum_safety)
  Level level;       ///< green if the finding is for information only
  int gear;          ///< 1, 2, or 0 for the pair
  std::string message, remedy{};       ///< one or more sentences each; the remedy may be empty
  std::vector<FindingValue> values{};  ///< if a clearance, a backlash, a contact ratio or a safety
                                       ///< factor is too small, this value comes first
  std::string at{};  ///< tolerance ends at which the finding occurs; empty for the nominal values
  std::optional<SpecChange> change{};  ///< the change in the remedy, if one was tried successfully

  /// Returns the tolerance ends at which the finding occurs, the message and the remedy, in this
  /// order. Empty parts are omitted.
  std::string whole() const;
  /// Returns whole(), preceded by "Gear 1: " or "Gear 2: " if no part of it names the gear.
  std::string named() const;
};

struct Verdict {
  Level level = Level::green;
  std::string headline;                 ///< plain text, without escapes
  std::vector<Finding> findings;        ///< worst first
  std::vector<std::string> not_judged;  ///< results that were not computed although the spec
                                        ///< contains data for them: pair, contact, load, rating
};

/// Margins in normal modules. A clearance below its margin produces a finding. The margin of the
/// fillet is small, because even in a good pair, the tip corner passes close to the fillet after it
/// has left the mating flank. The clearance between corner and fillet is only 0.0009 modules in a
/// 20:40 pair without profile shift, and it rarely exceeds 0.01 modules.
constexpr double kMarginForm = 0.01, kMarginFillet = 0.0001, kMarginTip = 0.1;
/// Greatest distance of the contact pattern from the middle of a face, relative to half of the face
/// width, at which the pattern still counts as central.
constexpr double kCentralPlace = 0.7;
/// Greatest distance of the pattern from the middle, relative to half of the face width, that may
/// remain after a remedy that centres the contact.
constexpr double kMiddlePlace = 0.1;

/// The data for a verdict. Its pointers must stay valid while a function below uses the data.
struct Judged {
  std::vector<const Gear*> gears;  ///< one or two gears; the gears of `pair`, if it is set
  const Pair* pair = nullptr;      ///< null if the gears are not mounted
  const RackPair* rack = nullptr;  ///< the pinion and its rack, if gear 2 is a rack
  const std::vector<Warning>* warnings = nullptr;  ///< warnings from all results
  const ContactResult* contact = nullptr;          ///< contact of the working flanks; null if not
                                                   ///< computed
  bool errors = false;                             ///< true if `contact` was computed under errors
  bool shifts_follow = false;  ///< true if the centre distance is given and a missing profile shift
                               ///< is computed from it
  /// True if the spec gives neither the centre distance nor all profile shifts. A given centre
  /// distance would then determine the missing profile shift.
  bool distance_sets_shifts = false;
  bool tolerances = false;  ///< true if findings are also computed at the tolerance
                            ///< ends
  std::optional<std::array<double, 2>> backlash_ends{};  ///< least and greatest j_n  mm, within the
                                                         ///< tolerances
  std::optional<PairRating> rating{};                    ///< none if not computed
};

/// True for a finding about a safety factor that is less than required.
bool is_safety(WarningCode code);

/// Returns, for example, " The lowest safety factor is 1.03 against pitting and 1.65 against root
/// breakage." The minimum is taken over both gears and all ratings. Without a rating, the text is
/// empty.
std::string safety_words(const std::vector<const Rating*>& ratings);

/// The place at which the teeth touch, over all positions with contact.
struct PatternPlace {
  /// Fraction of the positions with contact at which an edge touches. For a double-helical pair, an
  /// edge of either half counts.
  double edge_share;
  /// Mean position of the contact points along the face, relative to half of the face width,
  /// towards +z. The value applies to the gear on which the contact is nearer to an end of the
  /// face. If the widths differ, this is the narrower gear. None if all positions have contact
  /// lines.
  std::optional<double> mean;
};
/// Returns none if the contact was not computed or if no teeth touch.
std::optional<PatternPlace> pattern_place(const Judged& judged);

struct ChangedState {
  std::vector<Finding> findings;
  double contact_ratio = 0.0;  ///< 0 without a pair
  double backlash = 0.0;       ///< j_n  mm
  std::optional<PatternPlace> place{};
};
/// The results that are computed for a changed spec. With as_drawn, these are the nominal gears and
/// the nominal pair. at_tolerances adds all combinations of tolerance ends, and with_contact adds
/// the contact under the errors.
enum class TryDepth { as_drawn, at_tolerances, with_contact };
/// Computes the results of a spec with one change. Returns nothing if the changed gears cannot be
/// made or mounted.
using TryChange = std::function<std::optional<ChangedState>(const SpecChange&, TryDepth)>;

/// Returns all findings of one state of the gears, without remedies, in no particular order.
///
/// Domain    one or two gears; `warnings` is set (contract)
std::vector<Finding> findings_of(const Judged& judged);

/// True if a verdict lists `a` before `b`. The more severe finding comes first. Findings of the same
/// level are in the order of WarningCode, with two exceptions. Green findings keep their order.
/// Findings about safety factors also keep their order, because findings_of() has already sorted
/// them.
///
/// Law       a strict weak order
bool is_listed_before(const Finding& a, const Finding& b);

/// True if `a` is worse than `b`, which means that its level is more severe or, for equal
/// levels, that its first value is less. Both findings must have the same code and gear.
bool worse(const Finding& a, const Finding& b);

/// Returns the verdict with these findings for the judged data.
///
/// `attempt`  tries a change; if it is empty, remedies contain no numbers
Verdict verdict_of(const Judged& judged, std::vector<Finding> findings,
                   const TryChange& attempt = {});
inline Verdict verdict_of(const Judged& judged) { return verdict_of(judged, findings_of(judged)); }

}  // namespace gearwright
