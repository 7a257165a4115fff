#include "gearwright/figure/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/figure/markup.hpp"

namespace gearwright {

Ticks round_ticks(double lo, double hi, int most) {
  GW_EXPECTS(lo < hi && most >= 1);
  const double rough = (hi - lo) / most;
  double power = std::floor(std::log10(rough));
  double step = std::pow(10.0, power);
  for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
    // The tolerance 1e-9 also accepts a step that is too small only because of rounding.
    if (factor * std::pow(10.0, power) < rough * (1 - 1e-9)) continue;
    step = factor * std::pow(10.0, power);
    if (factor == 10.0) power += 1;
    break;
  }
  Ticks ticks{{}, std::max(0, static_cast<int>(-power))};
  const double first = std::ceil(lo / step - 1e-9);
  const double last = std::floor(hi / step + 1e-9);
  for (double k = first; k <= last; k += 1) ticks.values.push_back(k * step);
  return ticks;
}

Ticks log_ticks(double lo, double hi, double apart) {
  GW_EXPECTS(0.0 < lo && lo < hi);
  // `steps` is the finest list whose neighbouring values are at least `apart` decades apart.
  using List = std::vector<double>;
  const double room = std::pow(10.0, apart);
  const List steps = room <= 1.2   ? List{1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8}
                     : room <= 1.5 ? List{1, 2, 3, 5}
                     : room <= 2.0 ? List{1, 2, 5}
                                   : List{1};
  Ticks ticks{{}, -1};
  for (double k = std::floor(std::log10(lo)); k <= std::log10(hi); k += 1.0)
    for (const double step : steps)
      if (const double v = step * std::pow(10.0, k); v >= lo && v <= hi) ticks.values.push_back(v);
  return ticks;
}

std::string tick_text(double value, int decimals) {
  if (decimals < 0) {
    return value < 1000 ? fmt::format("{:g}", value)
                        : counted(static_cast<std::int64_t>(std::llround(value)));
  }
  return with_minus(fixed(value, decimals));
}

std::vector<double> levels_between(double lo, double hi, int most) {
  std::vector<double> levels = round_ticks(lo, hi, most).values;
  std::erase_if(levels, [&](double v) { return v <= lo || v >= hi; });
  return levels;
}

std::vector<double> widened(double lo, double hi, double share) {
  const double least = 1e-9 * std::max({std::abs(lo), std::abs(hi), 1e-9});
  const double by = std::max(share * (hi - lo), least);
  return {lo - by, hi + by};
}

}  // namespace gearwright
