// Numbers as text for people and files, each function one rule.
#pragma once

#include <string>

namespace gearwright {

/// The number with this many decimals, never "-0.00".
///
/// Domain    finite, decimals ≥ 0
std::string fixed_decimals(double x, int decimals);

/// The same without trailing zeros: "1.5", "2".
std::string short_decimals(double x, int most);

inline constexpr int kUsualDigits = 6;  ///< in sentences

/// The number with this many significant digits, or fewer if the number has no more: 0.1, not
/// 0.100000.
std::string with_digits(double x, int digits);

/// The number of significant digits that distinguishes x from `other`, at least six. It is six if they
/// never differ.
int digits_between(double x, double other);

/// A number in a sentence: six digits.
std::string format_number(double x);
/// A number with as many more digits as distinguish it from `other`.
std::string format_number(double x, double other);

}  // namespace gearwright
