// A number with so many decimals; what rounds to nothing has no sign. Internal to job/.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace gearwright {

inline std::string fixed_text(double v, int digits) {
  const double half = 0.5 * std::pow(10.0, -digits);
  return fmt::format("{:.{}f}", std::abs(v) < half ? 0.0 : v, digits);
}

}  // namespace gearwright
