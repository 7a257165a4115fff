// Formats numbers as text for users and for files, and reads numbers from text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace gearwright {

/// The number with this many decimals, never "-0.00".
///
/// Domain    finite, decimals ≥ 0
std::string fixed_decimals(double x, int decimals);

/// The number with at most `most` decimals and without trailing zeros: "1.5", "2".
std::string short_decimals(double x, int most);

/// The number rounded up or down to this many decimals. These functions are used for limits that
/// users copy. A lower limit is rounded up, so that the printed limit is not less than x, and an
/// upper limit is rounded down. If x has at most `decimals` decimals, apart from rounding errors,
/// these decimals are returned.
///
/// Domain    finite, decimals ≥ 0
double rounded_up(double x, int decimals);
double rounded_down(double x, int decimals);

inline constexpr int kUsualDigits = 6;  ///< significant digits of a number in a sentence

/// The number rounded to 15 significant digits, which removes the rounding error of a quotient:
/// 25.4/(25.4/3) becomes 3.
double without_rounding_error(double x);

/// The number with at most this many significant digits and no trailing zeros: 0.1, not 0.100000.
std::string with_digits(double x, int digits);

/// The least number of significant digits, but at least six, with which x and `other` are written
/// differently. The result is six if x and `other` are equal.
int digits_between(double x, double other);

/// A rough count with three significant digits, without an exponent below 10⁶: 1020, 2.5e+10.
std::string rough_count(double x);

/// The whole number or the finite decimal number of which a text consists, in every locale. Returns
/// none for all other texts, such as texts with spaces, hexadecimal numbers, "inf" and "nan".
std::optional<std::int64_t> whole_number(std::string_view text);
std::optional<double> decimal_number(std::string_view text);

/// A number with six significant digits, as it is written in a sentence.
std::string format_number(double x);
/// The number x with six digits, or with more if six do not distinguish x from `other`.
std::string format_number(double x, double other);

}  // namespace gearwright
