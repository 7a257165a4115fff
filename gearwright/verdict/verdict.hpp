// The verdict: whether the gears work and, if not, the reason and a remedy.
//
// One verdict covers all results of a job: warnings of gears, pair and contact, margins of
// clearances, the position of the contact under the errors, and safety factors. The worst finding
// comes first, and the headline states it in words. The command line, JSON, Python and the page
// print the same verdict.
//
// Findings are computed for the nominal values, or for all ends of the tolerances. In the second
// case they are merged, and the worst of each finding is kept. verdict_of adds tried remedies
// (remedy.hpp) and the headline.
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
/// A problem is red, a caution is amber, and a note is green.
Level level_of(Severity severity);

/// The least normal backlash of iron or steel gears in an iron or steel housing, for speeds below 15 m/s.
///
/// Formula   2/3 (0.06 + 0.0005 a + 0.03 m_n); ISO/TR 10064-2:1996, annex A
/// Units     mm
double recommended_backlash(double center_distance, double normal_module);

struct FindingValue {
  std::string name;
  double value;
  bool length;  ///< true for a length in mm, false for a pure number
};

/// A change of one number of a spec.
enum class Adjustable {
  profile_shift,        ///< x
  tip_diameter,         ///< d_a   mm
  thickness_allowance,  ///< E_sn  mm
  teeth,                ///< z
  helix_angle,          ///< β     degrees
  face_width,           ///< b     mm
  bore,                 ///< mm
  lead_crowning,        ///< C_β   µm, both flanks
  lead_slope,           ///< C_Hβ  µm, both flanks
  center_distance,      ///< a     mm, of the pair
};

/// A change of a spec.
struct SpecChange {
  Adjustable what;
  int gear;  ///< 1, 2; 0 for the pair or both gears
  double value;
  std::string path{};  ///< for a drive, the key in its spec; otherwise empty
};

struct Finding {
  WarningCode code;  ///< code of a warning or of a margin: form_margin, fillet_margin, tip_margin,
                     ///< edge_contact, contact_place, root_safety, flank_safety
  Level level;       ///< green if the finding is for information only
  int gear;          ///< 1, 2, or 0 for the pair
  std::string message, remedy{};       ///< one sentence each; the remedy may be empty
  std::vector<FindingValue> values{};  ///< the first is the number that is too small
  std::string at{};  ///< tolerance ends at which the finding occurs; empty for the nominal values
  std::optional<SpecChange> change{};  ///< the change that the remedy states and that was tried

  /// The message, with the tolerance ends at which it occurs, and the remedy.
  std::string whole() const;
};

struct Verdict {
  Level level = Level::green;
  std::string headline;                 ///< plain words, not escaped
  std::vector<Finding> findings;        ///< worst first
  std::vector<std::string> not_judged;  ///< results not computed although the spec has data:
                                        ///< pair, contact, load, rating
};

/// Margins in normal modules. A clearance below its margin is a finding. A tip corner that has left the
/// flank passes close to the fillet even in good pairs: the clearance of 20:40 without shift is
/// 0.0009 modules. Few pairs exceed 0.01, so a margin of that size would not be informative.
constexpr double kMarginForm = 0.01, kMarginFillet = 0.0001, kMarginTip = 0.1;
/// Greatest distance of a central pattern from the middle of either face, as a share of half its width.
constexpr double kCentralPlace = 0.7;

/// A rating and its inputs, which are needed because remedies are also rated.
struct JudgedRating {
  const RatedPair* pair = nullptr;
  const RatingInput* input = nullptr;
  const Rating* rating = nullptr;
  WantedSafety wanted{};
};

/// The data to be judged. All pointers must stay valid during the call.
struct Judged {
  std::vector<const Gear*> gears;  ///< one or two gears; if there is a pair, the gears of the pair
  const Pair* pair = nullptr;      ///< null if the gears are not mounted
  const RackPair* rack = nullptr;  ///< the rack, if gear 2 is one
  const std::vector<Warning>* warnings = nullptr;  ///< of all results
  const ContactResult* contact = nullptr;          ///< of the working flanks; null if not computed
  bool errors = false;                             ///< true if `contact` was computed under errors
  bool shifts_follow = false;  ///< true if a given centre distance determines an absent shift
  /// True if no centre distance is given, and a given centre distance would determine an absent shift.
  bool distance_sets_shifts = false;
  bool tolerances = false;               ///< true if findings are also judged at the tolerance ends
  std::optional<JudgedRating> rating{};  ///< none if not computed
};

/// " The least safety against pitting is 1.03, against root breakage 1.65.", over both gears of all
/// ratings; empty without ratings.
std::string safety_words(const std::vector<const Rating*>& ratings);

/// The results of a changed spec.
struct ChangedState {
  std::vector<Finding> findings;
  double contact_ratio = 0.0;  ///< 0 without a pair
  double backlash = 0.0;       ///< j_n  mm
};
/// The extent of the computation of a changed spec. as_drawn computes the gears and the pair as drawn,
/// at_tolerances also at the ends of the tolerances, and with_contact also the contact under the errors.
enum class TryDepth { as_drawn, at_tolerances, with_contact };
/// Solves a spec with one change. Nothing is returned if such gears cannot be made or mounted.
using TryChange = std::function<std::optional<ChangedState>(const SpecChange&, TryDepth)>;

/// All findings of one state of the gears, without remedies, in no particular order.
///
/// Domain    one or two gears, warnings (contract)
std::vector<Finding> findings_of(const Judged& judged);

/// True if `a` is worse than `b`, by level and then by the first value. Both have the same code and gear.
bool worse(const Finding& a, const Finding& b);

/// The verdict with these findings for the judged data.
///
/// `attempt`  tries changes; if it is empty, remedies contain no numbers
Verdict verdict_of(const Judged& judged, std::vector<Finding> findings,
                   const TryChange& attempt = {});
inline Verdict verdict_of(const Judged& judged) { return verdict_of(judged, findings_of(judged)); }

}  // namespace gearwright
