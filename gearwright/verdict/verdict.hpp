// The verdict: whether the gears work and, if not, the reason and a remedy.
//
// There is one verdict over all results of a job: warnings of gears, pair and contact, margins of
// clearances, the position of the contact under the errors, and safety factors. The worst finding
// comes first; the headline states it in words. Command line, JSON, Python and page print the same
// verdict.
//
// Findings are computed for the nominal values or for all ends of the tolerances and then merged;
// worse_of keeps the worst of each finding. verdict_of adds tried remedies (remedy.hpp) and the
// headline.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gearwright/contact/contact.hpp"
#include "gearwright/pair/pair.hpp"
#include "gearwright/rating/sizing.hpp"

namespace gearwright {

enum class Level {
  green,  ///< it runs, and nothing needs attention
  amber,  ///< it runs, but the user should check the findings
  red,    ///< it cannot be made or does not run as specified
};
const char* to_string(Level level);
/// A problem is red, a caution amber, a note green.
Level level_of(Severity severity);

/// The least normal backlash of gears and housing of iron or steel below 15 m/s.
///
/// Formula   2/3 (0.06 + 0.0005 a + 0.03 m_n); ISO/TR 10064-2:1996, annex A
/// Units     mm
double recommended_backlash(double center_distance, double normal_module);

struct FindingValue {
  std::string name;
  double value;
  bool length;  ///< mm; else a pure number
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
  std::string path{};  ///< for a drive: the key in its spec, else empty
};

struct Finding {
  WarningCode code;  ///< of a warning, or of a margin: form_margin, fillet_margin, tip_margin,
                     ///< edge_contact, contact_place, root_safety, flank_safety
  Level level;       ///< green: for information
  int gear;          ///< 1, 2, or 0 for the pair
  std::string message, remedy{};       ///< a sentence each; the remedy may be empty
  std::vector<FindingValue> values{};  ///< the first: the number that is too small
  std::string at{};                    ///< tolerance ends at which it occurs; empty as drawn
  std::optional<SpecChange> change{};  ///< the changes of the remedy, tried

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

/// Margins below which a clearance is a finding, in normal modules. A tip corner that has left the
/// flank passes close to the fillet even in good pairs: the clearance of 20:40 without shift is
/// 0.0009 modules. Few pairs exceed 0.01, so a margin of that size would not be informative.
constexpr double kMarginForm = 0.01, kMarginFillet = 0.0001, kMarginTip = 0.1;
/// Shares of half the common face: a pattern beyond this is not central.
constexpr double kCentralPlace = 0.7;

/// A rating and its inputs, which are needed because remedies are rated too.
struct JudgedRating {
  const RatedPair* pair = nullptr;
  const RatingInput* input = nullptr;
  const Rating* rating = nullptr;
  WantedSafety wanted{};
};

/// The data to be judged; all of it must outlive the call.
struct Judged {
  std::vector<const Gear*> gears;                  ///< one or two, with a pair its gears
  const Pair* pair = nullptr;                      ///< null if not mounted
  const std::vector<Warning>* warnings = nullptr;  ///< of all that was computed
  const ContactResult* contact = nullptr;          ///< of the working flanks; null if not computed
  bool errors = false;                             ///< it is under errors
  bool shifts_follow = false;                      ///< a given centre distance sets an absent shift
  bool distance_sets_shifts = false;     ///< no centre distance; one would set an absent shift
  bool tolerances = false;               ///< findings are judged at their ends too
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
/// The extent of the computation of a changed spec: gears and pair as drawn, also at the ends of
/// the tolerances, or also with contact under the errors.
enum class TryDepth { as_drawn, at_tolerances, with_contact };
/// Solves a spec with one change; none if such gears cannot be made or mounted.
using TryChange = std::function<std::optional<ChangedState>(const SpecChange&, TryDepth)>;

/// All findings of one state of the gears, without remedies, in no order.
///
/// Domain    one or two gears, warnings (contract)
std::vector<Finding> findings_of(const Judged& judged);

/// True if `a` is worse than `b`, both of one code and gear: by level, then by the first value.
bool worse(const Finding& a, const Finding& b);

/// The verdict over these findings of what is judged.
///
/// `attempt`  if empty, there are only remedies without numbers
Verdict verdict_of(const Judged& judged, std::vector<Finding> findings,
                   const TryChange& attempt = {});
inline Verdict verdict_of(const Judged& judged) { return verdict_of(judged, findings_of(judged)); }

}  // namespace gearwright
