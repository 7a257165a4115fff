// The error of an input, with the information that the user needs to correct the input.
//
//   field   the member of the library's structs, "tip_diameter", "rack.dedendum", "gear1.teeth"
//   value   the value of this member, with as many digits as the user needs
//   rule    one sentence with the fault, the allowed range and its reason, and a remedy. The names
//           of other members are in backticks: `pair.center_distance`
//
// C++ callers receive this text unchanged. Interfaces that read files replace the member names by
// the keys of the file (catalogue/spelling.hpp) and keep the sentence.
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/base/number_text.hpp"

namespace gearwright {

/// The kind of an error, for decisions in code. `rule` is a text for users only.
enum class FailureKind {
  value,            ///< the value, or the input as a whole, violates the rule
  missing,          ///< the input lacks the field
  no_flank,         ///< a gear has no usable flank
  placement,        ///< the gears cannot be placed or shaped as the input requires
  nothing_touches,  ///< the teeth of the two gears touch at no position
  not_under_load,   ///< teeth of this kind are not computed under load
  not_converged,    ///< the forces under load converge at no position
  not_in_build,     ///< this build cannot compute the result
  option,           ///< the field is an option of the command line, not a part of the input
  file,             ///< a file of the input cannot be read
  defect,           ///< a contract is violated (base/contract.hpp)
  count             ///< the number of kinds, not a kind
};

struct FailureMeaning {
  FailureKind kind;
  const char* text;      ///< the name of the kind in results, such as "missing"
  const char* sentence;  ///< the meaning of the kind, used in documents
};
/// Returns the row of every kind, in the order of the enumerators.
std::span<const FailureMeaning> failure_meanings();
const char* to_string(FailureKind kind);

struct Error {
  std::string field;  ///< empty if the error concerns no single member
  std::string value;  ///< empty if the value does not fit into a sentence
  std::string rule;
  FailureKind kind = FailureKind::value;

  /// "rack.dedendum = 9: the tooth of the cutter becomes pointed before …"
  std::string message() const;
  /// The message as part of another sentence, with the field in backticks: "`rack.dedendum` = 9:
  /// …".
  std::string quoted() const;
};

/// The error of a missing field. `rest` is appended to "is missing", for example "; a pair needs a
/// second gear".
Error absent_input(std::string field, std::string_view rest = {});

/// The error {field, value, rule} with the value written to six digits.
Error refused(std::string field, double value, std::string rule);
Error refused(std::string field, int value, std::string rule);

/// The error of a value outside its limits. `rule` contains one {} for each limit. The value
/// and the limits are written with six digits, or with more if six do not distinguish them. A
/// limit is rounded towards the allowed side, so that the printed limit is itself allowed. If
/// there are two limits, the first is the least and the second the greatest allowed value.
Error refused(std::string field, double value, std::initializer_list<double> limits,
              std::string_view rule);

/// The same error with the name of the owner `whole` in front of the field. If `whole` is "gear1",
/// the field "rack.dedendum" becomes "gear1.rack.dedendum".
Error within(std::string_view whole, Error error);

/// The error of a derived value, attributed to the input that causes it: "pair.center_distance =
/// 30: it requires `gear1.profile_shift` = -3: …".
Error following_from(std::string field, std::string value, std::string_view how,
                     const Error& error);

// Combines all missing inputs in one error, so that the user sees all of them at once.

/// The first error, with the other missing inputs appended to its rule: "…; also missing:
/// rating.quality (the accuracy grades …), …". Each field and each explanation occurs once. If
/// there are errors of other kinds than `missing`, returns only the first of these.
///
/// Domain    at least one error (contract)
Error all_missing(const std::vector<Error>& errors);

}  // namespace gearwright
