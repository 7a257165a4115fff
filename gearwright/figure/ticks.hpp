// Round values for the ticks of an axis, and for the levels of a map.
#pragma once

#include <string>
#include <vector>

namespace gearwright {

struct Ticks {
  std::vector<double> values;
  int decimals;  ///< decimals that distinguish the values; −1: each value has its own number
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

/// The value of a tick with this number of decimals and a true minus; −1 decimals, for logarithmic
/// axes: as it is. Large values have digits in groups of three.
std::string tick_text(double value, int decimals);

/// Those of round_ticks that lie between lo and hi.
std::vector<double> levels_between(double lo, double hi, int most);

/// lo … hi widened by `share` of its length on both sides. A single value gets some range.
std::vector<double> widened(double lo, double hi, double share);

}  // namespace gearwright
