// Formats numbers as text for users and for files.
#pragma once

#include <string>

namespace gearwright {

/// The number with this many decimals, never "-0.00".
///
/// Domain    finite, decimals ≥ 0
std::string fixed_decimals(double x, int decimals);

/// The number with at most `most` decimals and without trailing zeros: "1.5", "2".
std::string short_decimals(double x, int most);

/// The number rounded up or down to this many decimals. It is used for limits that users copy, so
/// that a printed lower limit is not less than x and a printed upper limit is not greater. A number
/// that already has at most `decimals` decimals, apart from rounding errors, is returned unchanged.
///
/// Domain    finite, decimals ≥ 0
double rounded_up(double x, int decimals);
double rounded_down(double x, int decimals);

inline constexpr int kUsualDigits = 6;  ///< significant digits of a number in a sentence

/// The number with at most this many significant digits and no trailing zeros: 0.1, not 0.100000.
std::string with_digits(double x, int digits);

/// The number of significant digits, at least six, that is needed to distinguish x from `other`.
/// The result is six if x and `other` are equal.
int digits_between(double x, double other);

/// A rough count with three significant digits, without an exponent below 10⁶: 1020, 2.5e+10.
std::string rough_count(double x);

/// A number with six significant digits, as it is written in a sentence.
std::string format_number(double x);
/// The number x with six digits, or with more if six do not distinguish x from `other`.
std::string format_number(double x, double other);

}  // namespace gearwright
