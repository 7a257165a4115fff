#include "gearwright/drive/rational.hpp"

#include <limits>
#include <numeric>
#include <utility>

#include "gearwright/base/contract.hpp"

namespace gearwright {

namespace {

using Wide = Rational::Wide;

constexpr Wide kMost = 2 * ((Wide{1} << (8 * sizeof(Wide) - 2)) - 1) + 1;  ///< greatest number

Wide magnitude(Wide n) { return n < 0 ? -n : n; }

/// True if both numbers have at most 31 bits. This applies to almost all numbers of a drive. Such
/// numbers are divided as int, because a division of wide numbers is a function call.
bool are_short(Wide a, Wide b) {
  constexpr int kMostShort = std::numeric_limits<int>::max();
  return magnitude(a) <= kMostShort && magnitude(b) <= kMostShort;
}

Wide divided(Wide a, Wide b) {
  return are_short(a, b) ? static_cast<int>(a) / static_cast<int>(b) : a / b;
}

/// Returns a·b, or none outside −kMost … kMost. The range is symmetric, so it also contains the
/// negative of every number in it.
std::optional<Wide> product(Wide a, Wide b) {
  if (are_short(a, b)) return a * b;
  if (b != 0 && magnitude(a) > kMost / magnitude(b)) return std::nullopt;
  return a * b;
}

/// Returns a + b, or none outside −kMost … kMost.
std::optional<Wide> sum(Wide a, Wide b) {
  if (b > 0 ? a > kMost - b : a < -kMost - b) return std::nullopt;
  return a + b;
}

Wide common_divisor(Wide a, Wide b) {
  if (are_short(a, b)) return std::gcd(static_cast<int>(a), static_cast<int>(b));
  a = magnitude(a);
  b = magnitude(b);
  while (b != 0) a = std::exchange(b, a % b);
  return a;
}

std::optional<long long> narrow(Wide n) {
  if (n < std::numeric_limits<long long>::min() || n > std::numeric_limits<long long>::max())
    return std::nullopt;
  return static_cast<long long>(n);
}

}  // namespace

Rational Rational::lowest(Wide p, Wide q) {
  const Wide d = q < 0 ? -common_divisor(p, q) : common_divisor(p, q);
  return {divided(p, d), divided(q, d)};
}

Rational Rational::of(long long p, long long q) {
  GW_EXPECTS(q != 0);
  return lowest(p, q);
}

int Rational::sign() const {
  GW_EXPECTS(fits());
  return p_ > 0 ? 1 : p_ < 0 ? -1 : 0;
}

std::optional<long long> Rational::numerator() const {
  return fits() && narrow(q_) ? narrow(p_) : std::nullopt;
}

std::optional<long long> Rational::denominator() const {
  return fits() && narrow(p_) ? narrow(q_) : std::nullopt;
}

Rational Rational::floor() const {
  if (!fits()) return *this;
  return {p_ % q_ < 0 ? p_ / q_ - 1 : p_ / q_, 1};
}

Rational Rational::frac() const { return *this - floor(); }

Rational operator+(const Rational& a, const Rational& b) {
  if (!a.fits() || !b.fits()) return Rational::too_large();
  if (a.q_ == 1 && b.q_ == 1 && are_short(a.p_, b.p_)) return {a.p_ + b.p_, 1};
  const Wide d = common_divisor(a.q_, b.q_);
  const auto left = product(a.p_, divided(b.q_, d)), right = product(b.p_, divided(a.q_, d));
  const auto p = left && right ? sum(*left, *right) : std::nullopt,
             q = product(divided(a.q_, d), b.q_);
  return p && q ? Rational::lowest(*p, *q) : Rational::too_large();
}

Rational operator*(const Rational& a, const Rational& b) {
  if (!a.fits() || !b.fits()) return Rational::too_large();
  if (a.q_ == 1 && b.q_ == 1 && are_short(a.p_, b.p_)) return {a.p_ * b.p_, 1};
  // Common factors of a numerator and the denominator of the other fraction are cancelled before
  // the multiplication. The products are then in lowest terms and as small as possible.
  const Wide d = common_divisor(a.p_, b.q_);
  const Wide e = common_divisor(b.p_, a.q_);
  const auto p = product(divided(a.p_, d), divided(b.p_, e));
  const auto q = product(divided(a.q_, e), divided(b.q_, d));
  return p && q ? Rational(*p, *q) : Rational::too_large();
}

Rational operator/(const Rational& a, const Rational& b) {
  if (!a.fits() || !b.fits()) return Rational::too_large();
  GW_EXPECTS(b.p_ != 0);
  return a * (b.p_ < 0 ? Rational(-b.q_, -b.p_) : Rational(b.q_, b.p_));
}

bool operator==(const Rational& a, const Rational& b) {
  GW_EXPECTS(a.fits() && b.fits());
  return a.p_ == b.p_ && a.q_ == b.q_;
}

Rational least_common_multiple(const Rational& a, const Rational& b) {
  // If b/a = n/d in lowest terms, then d = a/gcd(a, b), and lcm(a, b) = a b/gcd(a, b) = b d.
  if (!a.fits() || !b.fits()) return a + b;
  const Rational quotient = b / a;
  const auto denominator = quotient.denominator();
  return denominator ? b * Rational(*denominator) : Rational::too_large();
}

std::vector<std::size_t> reduce_rows(RationalMatrix& rows, std::size_t columns) {
  std::vector<std::size_t> pivots;
  for (std::size_t column = 0; column < columns && pivots.size() < rows.size(); ++column) {
    const std::size_t top = pivots.size();
    std::size_t pivot = top;
    while (pivot < rows.size() && rows[pivot][column].zero()) ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[top], rows[pivot]);
    // Most entries of the rows of a drive are 0. They stay 0 unless a fraction has overflowed, and
    // are therefore skipped.
    const Rational lead = rows[top][column];
    for (Rational& x : rows[top])
      if (!(x.zero() && lead.fits())) x = x / lead;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Rational factor = rows[i][column];
      if (i == top || factor.zero()) continue;
      for (std::size_t j = 0; j < rows[i].size(); ++j)
        if (!(rows[top][j].zero() && factor.fits()))
          rows[i][j] = rows[i][j] - factor * rows[top][j];
    }
    pivots.push_back(column);
  }
  return pivots;
}

std::optional<std::size_t> rank_of(RationalMatrix rows) {
  if (rows.empty()) return 0;
  const std::size_t rank = reduce_rows(rows, rows.front().size()).size();
  for (const auto& row : rows)
    for (const Rational& x : row)
      if (!x.fits()) return std::nullopt;
  return rank;
}

RationalMatrix left_kernel(const RationalMatrix& rows) {
  if (rows.empty()) return {};
  // Reduces [A | I]. If the part of a row in A becomes 0, its part in I is a y with y·A = 0.
  const std::size_t columns = rows.front().size();
  RationalMatrix both = rows;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    both[i].resize(columns + rows.size());
    both[i][columns + i] = 1;
  }
  const std::size_t rank = reduce_rows(both, columns).size();
  RationalMatrix kernel;
  for (std::size_t i = rank; i < both.size(); ++i)
    kernel.emplace_back(both[i].begin() + static_cast<std::ptrdiff_t>(columns), both[i].end());
  return kernel;
}

}  // namespace gearwright
