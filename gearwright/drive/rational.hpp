// Exact fractions of whole numbers. After an overflow, a fraction is in a separate state, so the
// result is never a wrong number.
//
//   p/q in lowest terms, q > 0; q = 0 after an overflow
//                                              theory: docs/theory/13-drives.md, [T13.3]
//
// An overflow occurs if a result does not fit into 127 bits, or into 63 bits if the compiler has no
// wider integers. Like NaN, an overflow affects every fraction that is computed from the overflowed
// one. The caller therefore checks only the last result.
#pragma once

#include <optional>
#include <vector>

namespace gearwright {

class Rational {
 public:
#ifdef __SIZEOF_INT128__
  __extension__ using Wide = __int128;
#else
  using Wide = long long;
#endif

  Rational() = default;  ///< 0
  Rational(long long whole)
      : p_(whole) {}  // NOLINT(google-explicit-constructor): a whole number is
                      // a fraction
  /// Returns the fraction p/q.   Domain  q ≠ 0 (contract)
  static Rational of(long long p, long long q);
  static Rational too_large() { return {0, 0}; }  ///< a fraction in the state of overflow

  bool fits() const { return q_ != 0; }
  bool zero() const { return q_ != 0 && p_ == 0; }
  bool whole() const { return q_ == 1; }
  /// Returns the sign: −1, 0 or 1.   Domain  fits() (contract)
  int sign() const;
  double value() const { return static_cast<double>(p_) / static_cast<double>(q_); }
  /// Return p and q, or none after an overflow or if p or q has more than 63 bits.
  std::optional<long long> numerator() const;
  std::optional<long long> denominator() const;
  /// Returns v − floor(v), in [0, 1).
  Rational frac() const;
  Rational floor() const;

  friend Rational operator+(const Rational& a, const Rational& b);
  friend Rational operator-(const Rational& a, const Rational& b) { return a + -b; }
  friend Rational operator*(const Rational& a, const Rational& b);
  /// Returns the quotient a/b.   Domain  b ≠ 0 (contract)
  friend Rational operator/(const Rational& a, const Rational& b);
  Rational operator-() const { return {-p_, q_}; }
  /// True if the fractions are equal.   Domain  neither has overflowed (contract)
  friend bool operator==(const Rational& a, const Rational& b);

 private:
  Rational(Wide p, Wide q) : p_(p), q_(q) {}
  static Rational lowest(Wide p, Wide q);

  Wide p_ = 0, q_ = 1;
};

/// Returns the least common multiple of two whole numbers > 0. The result is an overflow if one of
/// the numbers has overflowed or if the multiple does not fit.
Rational least_common_multiple(const Rational& a, const Rational& b);

/// A matrix as a list of rows of equal length.
using RationalMatrix = std::vector<std::vector<Rational>>;

/// Reduces the rows so that each leading entry is 1 and is the only entry ≠ 0 in its column. Only
/// the first `columns` columns can contain leading entries. The function returns the column of the
/// leading entry for each row that has one.
///
/// Formula   Gauss–Jordan elimination with exact fractions, so the rank is exact
std::vector<std::size_t> reduce_rows(RationalMatrix& rows, std::size_t columns);

/// Returns the rank of the matrix, or none after an overflow.
std::optional<std::size_t> rank_of(RationalMatrix rows);

/// Returns a basis of all y with y·A = 0 for A = `rows`, one y in each row. The result is empty if
/// the rows are independent. After an overflow, the result is not reliable.
RationalMatrix left_kernel(const RationalMatrix& rows);

}  // namespace gearwright
