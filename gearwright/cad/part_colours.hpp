// Colours of parts, so that gears in contact are told apart wherever their file is opened.
#pragma once

#include <array>
#include <cstddef>

namespace gearwright {

/// Linear RGB, far apart in lightness as well as hue: steel, bronze, blue, green.
inline constexpr std::array<std::array<double, 3>, 4> kPartColours{
    {{0.45, 0.49, 0.53}, {0.55, 0.34, 0.14}, {0.12, 0.26, 0.48}, {0.2, 0.42, 0.24}}};

/// Of the part with this index; after the last colour comes the first.
constexpr const std::array<double, 3>& part_colour(std::size_t index) {
  return kPartColours[index % kPartColours.size()];
}

}  // namespace gearwright
