// Round values for the ticks of an axis, and for the levels of a map.
#pragma once

#include <string>
#include <vector>

namespace gearwright {

struct Ticks {
  std::vector<double> values;
  int decimals;  ///< by which they differ; −1: each has its own
};

/// Round values within [lo, hi]: multiples of 1, 2 or 5 times a power of ten.
///
/// Domain    lo < hi, most ≥ 1 (contract)
/// Laws      at most most + 1 values
Ticks round_ticks(double lo, double hi, int most);

/// Round values within [lo, hi] of an axis of powers, neighbours at least `apart` decades from each
/// other.
///
/// Domain    0 < lo < hi (contract)
Ticks log_ticks(double lo, double hi, double apart);

/// The value of a tick: with so many decimals and a true minus; of an axis of powers (−1) as it is,
/// great ones in groups of three digits.
std::string tick_text(double value, int decimals);

/// Those of round_ticks that lie between lo and hi.
std::vector<double> levels_between(double lo, double hi, int most);

/// lo … hi widened by `share` of its length on both sides; a single value gets room of its own.
std::vector<double> widened(double lo, double hi, double share);

}  // namespace gearwright
