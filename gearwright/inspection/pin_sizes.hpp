// The common diameters of measuring pins and balls for gears, DIN 3977. Internal to inspection/.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace gearwright {

inline constexpr std::array kPinSizes_mm{
    0.3,  0.35, 0.4,  0.45, 0.5,  0.55, 0.6,  0.65, 0.7,  0.75, 0.8,  0.85, 0.9,  0.95, 1.0,  1.1,
    1.2,  1.3,  1.4,  1.5,  1.6,  1.7,  1.8,  1.9,  2.0,  2.25, 2.5,  2.75, 3.0,  3.25, 3.5,  3.75,
    4.0,  4.25, 4.5,  5.0,  5.25, 5.5,  6.0,  6.5,  7.0,  7.5,  8.0,  9.0,  10.0, 10.5, 11.0, 12.0,
    14.0, 15.0, 16.0, 18.0, 20.0, 22.0, 25.0, 28.0, 30.0, 35.0, 40.0, 45.0, 50.0};

/// Returns the size nearest to `mm` for which `fits(size)` is true. Returns none if no size fits.
template <class Fits>
std::optional<double> nearest_pin_size(double mm, const Fits& fits) {
  auto sizes = kPinSizes_mm;
  std::stable_sort(sizes.begin(), sizes.end(),
                   [&](double a, double b) { return std::abs(a - mm) < std::abs(b - mm); });
  const auto found = std::find_if(sizes.begin(), sizes.end(), fits);
  return found == sizes.end() ? std::nullopt : std::optional(*found);
}

}  // namespace gearwright
