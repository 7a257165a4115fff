// What is wrong with an input, so that whoever gave it can mend it.
//
//   field   the member of the library's structs, "tip_diameter", "rack.dedendum", "gear1.teeth"
//   value   what stands there, with the digits that a person uses
//   rule    one sentence: what is wrong, what is allowed and why, what would help. Other members
//           stand in it between backticks, `pair.center_distance`
//
// A programmer reads it as it is; a door with a file puts the file's keys in place of the members
// (catalogue/spelling.hpp), and the sentence stays.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "gearwright/base/number_text.hpp"

namespace gearwright {

/// What went wrong, where code goes on differently. The rule is for people only.
enum class FailureKind {
  value,            ///< the value, or the input as a whole, breaks the rule
  missing,          ///< the input lacks the field
  no_flank,         ///< a gear has no usable flank to touch with
  placement,        ///< two gears cannot be placed, or have no helix or shift, as the input asks
  nothing_touches,  ///< at no position do teeth of the two gears touch
  not_under_load,   ///< teeth of this kind are not computed under load
  not_in_build,     ///< this build has no part that computes it
};

struct Error {
  std::string field;  ///< empty: of no member
  std::string value;  ///< empty: none, or none that a sentence could show
  std::string rule;
  FailureKind kind = FailureKind::value;

  /// "rack.dedendum = 9: the cutter's tooth is pointed before it gets that deep; …"
  std::string message() const;
  /// The same as a part of another sentence: "`rack.dedendum` = 9: …".
  std::string quoted() const;
};

/// The field is missing. `rest` continues the sentence "is missing": "; a pair needs a second gear".
Error absent_input(std::string field, std::string_view rest = {});

/// {field, value, rule}, the value with six digits.
Error refused(std::string field, double value, std::string rule);
Error refused(std::string field, int value, std::string rule);

/// The same where the value passes one of the limits: `rule` has {} for each of them. Value and
/// limits get six digits, or as many as tell them apart; a limit is not rounded past itself: what
/// is said to be allowed is. Two limits are the least and the greatest value.
Error refused(std::string field, double value, std::initializer_list<double> limits,
              std::string_view rule);

/// The error of a part as one of the whole: "rack.dedendum" of "gear1" is "gear1.rack.dedendum".
Error within(std::string_view whole, Error error);

/// The same fact told of the input that it follows from: "pair.center_distance = 30: it asks for
/// `gear1.profile_shift` = -3: …".
Error following_from(std::string field, std::string value, std::string_view how,
                     const Error& error);

}  // namespace gearwright
