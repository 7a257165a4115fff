// The keys of [contact] and [contact.map]: the resolution of the contact analysis of a pair.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/catalogue/error_keys.hpp"
#include "gearwright/catalogue/key.hpp"

namespace gearwright {

/// [contact.map]: a map of the peak-to-peak transmission error over two errors.
struct ContactMapInput {
  std::array<std::size_t, 2> key{};              ///< indices of x and y in error_entries
  std::array<std::array<double, 2>, 2> range{};  ///< lower and upper end for x and y
  std::array<int, 2> points{21, 21};
};

/// [contact]
struct ContactInput {
  bool given = false;
  int positions = 64;  ///< number of positions per pitch
  int pitches = 1;
  double marking = 0.00635;  ///< mm
  int driver = 1;
  bool pattern = false;          ///< true if the result includes the raster of both flanks
  std::vector<Angle> rotations;  ///< rotations of gear 1, used instead of positions
  std::optional<ContactMapInput> map;
};

constexpr int kMaxPositions = 1'000'000;  ///< limit for positions times pitches

const KeyTable& contact_keys();
const KeyTable& contact_map_keys();

}  // namespace gearwright
