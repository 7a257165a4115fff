// The keys of [contact] and [contact.map]: the resolution of the contact analysis of a pair.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/catalogue/error_keys.hpp"
#include "gearwright/catalogue/key.hpp"

namespace gearwright {

/// [contact.map]: peak to peak over two errors.
struct ContactMapInput {
  std::array<std::size_t, 2> key{};              ///< of x and of y: index in error_entries
  std::array<std::array<double, 2>, 2> range{};  ///< lo and hi of x and of y
  std::array<int, 2> points{21, 21};
};

/// [contact]
struct ContactInput {
  bool given = false;
  int positions = 64;  ///< per pitch
  int pitches = 1;
  double marking = 0.00635;  ///< mm
  int driver = 1;
  bool pattern = false;          ///< the raster of both flanks is included in the result
  std::vector<Angle> rotations;  ///< rotations of gear 1, used instead of positions
  std::optional<ContactMapInput> map;
};

constexpr int kMaxPositions = 1'000'000;  ///< positions times pitches

const KeyTable& contact_keys();
const KeyTable& contact_map_keys();

}  // namespace gearwright
