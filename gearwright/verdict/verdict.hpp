// What a person wants to know first: does it work, and if not, why, and what would help.
//
// One verdict over everything that is known of a job: warnings of gears, pair and contact, margins
// of clearances, where the teeth touch under the errors, safeties. The worst finding comes first; the
// headline states it in words. Command line, JSON, Python and page print the same verdict.
//
// Findings are made at one place, or at several (the ends of tolerances), and merged: worse_of keeps
// of each finding the worst. verdict_of adds remedies, which are tried (remedy.hpp), and the headline.
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
  green,  ///< it runs, and nothing asks for a look
  amber,  ///< it runs; the user should look at what was found
  red,    ///< as specified it cannot be made or does not run
};
const char* to_string(Level level);

struct FindingValue {
  std::string name;
  double value;
  bool length;  ///< mm; else a pure number
};

/// One number of a spec that can be set to another value.
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
  int gear;  ///< 1, 2; 0: of the pair, or of both gears
  double value;
};

struct Finding {
  WarningCode code;  ///< of a warning, or of a margin: form_margin, fillet_margin, tip_margin,
                     ///< edge_contact, contact_place, root_safety, flank_safety
  Level level;       ///< green: good to know
  int gear;          ///< 1, 2, or 0 for the pair
  std::string message, remedy{};       ///< a sentence each; the remedy may be empty
  std::vector<FindingValue> values{};  ///< the first: the number that is too small
  std::string at{};                    ///< the ends of tolerances where it is so; empty: as drawn
  std::optional<SpecChange> change{};  ///< what the remedy states, tried

  /// The message, with where it holds, and the remedy.
  std::string whole() const;
};

struct Verdict {
  Level level = Level::green;
  std::string headline;                 ///< plain words, not escaped
  std::vector<Finding> findings;        ///< worst first
  std::vector<std::string> not_judged;  ///< what the spec has data for and was not computed:
                                        ///< pair, contact, load, rating
};

/// Margins below which a clearance is worth a look, in normal modules. A tip corner that has left
/// the flank runs close by the fillet in the best of pairs: 20:40 without shift keeps 0.0009 modules,
/// and so few stay above 0.01 that a margin of that size would say nothing.
constexpr double kMarginForm = 0.01, kMarginFillet = 0.0001, kMarginTip = 0.1;
/// Shares of half the common face: further out than that the pattern is not in its middle.
constexpr double kCentralPlace = 0.7;

/// A rating, and what made it: remedies are rated, too.
struct JudgedRating {
  const RatedPair* pair = nullptr;
  const RatingInput* input = nullptr;
  const Rating* rating = nullptr;
  WantedSafety wanted{};
};

/// What is to be judged; all outlive the call.
struct Judged {
  std::vector<const Gear*> gears;                  ///< one or two, with a pair its gears
  const Pair* pair = nullptr;                      ///< null: not mounted
  const std::vector<Warning>* warnings = nullptr;  ///< of all that was computed
  const ContactResult* contact = nullptr;          ///< of the working flanks; null: not computed
  bool errors = false;                             ///< it is under errors
  bool shifts_follow = false;         ///< a given centre distance sets an absent profile shift
  bool distance_sets_shifts = false;  ///< none is given; a profile shift is absent and would follow
  bool tolerances = false;            ///< findings are judged at their ends too
  std::optional<JudgedRating> rating{};  ///< none: not computed
};

/// What a changed spec would be like.
struct ChangedState {
  std::vector<Finding> findings;
  double contact_ratio = 0.0;  ///< 0: no pair
  double backlash = 0.0;       ///< j_n  mm
};
/// How much of a changed spec is computed: gears and pair as drawn, at the ends of the tolerances
/// too, or with contact under the errors besides.
enum class TryDepth { as_drawn, at_tolerances, with_contact };
/// Solves a spec with one change; none: such gears cannot be made or mounted.
using TryChange = std::function<std::optional<ChangedState>(const SpecChange&, TryDepth)>;

/// All findings of one state of the gears, without remedies, in no order.
///
/// Domain    one or two gears, warnings (contract)
std::vector<Finding> findings_of(const Judged& judged);

/// Over the usable flanks and the whole face.
double true_contact_ratio(const Pair& pair);

/// Whether `a` is worse than `b`, both of one code and gear: by level, then by the first value.
bool worse(const Finding& a, const Finding& b);

/// The verdict over these findings of what is judged.
///
/// `attempt`  empty: remedies without numbers only
Verdict verdict_of(const Judged& judged, std::vector<Finding> findings,
                   const TryChange& attempt = {});
inline Verdict verdict_of(const Judged& judged) { return verdict_of(judged, findings_of(judged)); }

}  // namespace gearwright
