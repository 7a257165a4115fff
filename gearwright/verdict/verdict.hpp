// What a person wants to know first: does it work, and if not, why, and what would help.
//
// One verdict over everything that is known of a job: warnings of gears, pair and contact, margins
// of clearances, where the teeth touch under the errors. The worst finding comes first; the
// headline says it in words. Command line, JSON and page say the same.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gearwright/contact/contact.hpp"
#include "gearwright/pair/pair.hpp"
#include "gearwright/rating/sizing.hpp"
#include "gearwright/verdict/meaning.hpp"

namespace gearwright {

enum class Level {
  green,  ///< it runs, and nothing asks for a look
  amber,  ///< it runs; somebody should look at what was found
  red,    ///< as specified it cannot be made or does not run
};
const char* to_string(Level level);

struct FindingValue {
  std::string name;
  double value;
  bool length;  ///< mm; else a share
};

struct Finding {
  std::string code;  ///< of a warning, or of a margin: form_margin, fillet_margin, tip_margin,
                     ///< edge_contact, contact_place, root_safety, flank_safety
  Level level;       ///< green: good to know
  int gear;          ///< 1, 2, or 0 for the pair
  std::string message, remedy;  ///< a sentence each; the remedy may be empty
  std::vector<FindingValue> values{};
  bool told = false;  ///< the message says the remedy too

  /// The message, and the remedy where the message is without.
  std::string whole() const { return told || remedy.empty() ? message : message + " " + remedy; }
};

struct Verdict {
  Level level = Level::green;
  std::string headline;           ///< plain words, not escaped
  std::vector<Finding> findings;  ///< worst first
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
  const std::vector<Warning>* warnings = nullptr;  ///< of all that was asked
  const ContactResult* contact = nullptr;          ///< of the working flanks; null: not asked
  bool errors = false;                             ///< it is under errors
  bool shifts_follow = false;  ///< a given centre distance asked for the profile shifts
  std::optional<JudgedRating> rating{};            ///< none: not asked
};

/// Domain    one or two gears, warnings (contract)
Verdict verdict_of(const Judged& judged);

}  // namespace gearwright
