#include "gearwright/base/angle.hpp"

#include <utility>

#include "gearwright/base/contract.hpp"

namespace gearwright {

SinCos sincos_turn(long long k, long long n) {
  GW_EXPECTS(n >= 1);
  k %= n;
  if (k < 0) k += n;
  // k/n of a turn is q quadrants plus r/(4n) of a turn, with 0 <= r < n.
  const long long q = (4 * k) / n;
  const long long r = 4 * k - q * n;
  // If r/(4n) exceeds an eighth of a turn, the code computes the sine and cosine of
  // (n − r)/(4n) of a turn and exchanges them. This angle is smaller, and n − r is exact.
  const bool swap = 2 * r > n;
  const double part = static_cast<double>(swap ? n - r : r) / static_cast<double>(n);
  const double angle = part * (std::numbers::pi / 2);
  double s = std::sin(angle);
  double c = std::cos(angle);
  if (swap) std::swap(s, c);
  switch (q) {
    case 0: return {s, c};
    // 0.0 − s is used instead of −s, because quarter turns must not give negative zeros.
    case 1: return {c, 0.0 - s};
    case 2: return {0.0 - s, -c};
    default: return {-c, s};
  }
}

}  // namespace gearwright
