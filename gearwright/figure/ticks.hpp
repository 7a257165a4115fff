// Computes round values for the ticks of an axis and for the levels of a map.
#pragma once

#include <string>
#include <vector>

namespace gearwright {

struct Ticks {
  std::vector<double> values;
  int decimals;  ///< decimals of every value; −1 if each value has as many as it needs
};

/// Returns round values within [lo, hi]: multiples of 1, 2 or 5 times a power of ten.
///
/// Domain    lo < hi, most ≥ 1 (contract)
/// Laws      the number of values is at most `most` + 1
Ticks round_ticks(double lo, double hi, int most);

/// Returns round values within [lo, hi] of a logarithmic axis. Neighbours are at least `apart`
/// decades from each other, or one decade if `apart` is greater.
///
/// Domain    0 < lo < hi (contract)
Ticks log_ticks(double lo, double hi, double apart);

/// Formats the value of a tick with this number of decimals and a true minus sign. If `decimals` is
/// −1, as for logarithmic axes, the value is written with as many digits as it needs. The digits of
/// large values are in groups of three.
std::string tick_text(double value, int decimals);

/// Returns the values of round_ticks() that lie between lo and hi, without lo and hi themselves.
std::vector<double> levels_between(double lo, double hi, int most);

/// Returns the ends of [lo, hi] widened by `share` of its length on both sides. If lo = hi, the
/// result still has a small length.
std::vector<double> widened(double lo, double hi, double share);

}  // namespace gearwright
