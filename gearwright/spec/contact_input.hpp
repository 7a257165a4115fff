// The tables [errors] and [contact]: what contact is asked under, and how finely. Units of the
// spec: mm, degrees, µm.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/contact/contact_pair.hpp"

namespace gearwright {

/// The keys of [errors], in the order of the interface.
inline constexpr std::array<const char*, 8> kErrorKeys{
    "center_distance_mm", "crossing_deg",    "intersecting_deg", "axial_mm",
    "helix_slope1_um",    "helix_slope2_um", "cutter_lead1_deg", "cutter_lead2_deg"};

/// [errors], a value for each of kErrorKeys.
struct ErrorsInput {
  std::array<double, kErrorKeys.size()> value{};
  bool given = false;
};

/// [contact.map]: peak to peak over two errors.
struct ContactMapInput {
  std::array<std::size_t, 2> key{};              ///< index in kErrorKeys, of x and of y
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
  bool pattern = false;           ///< the raster of both flanks is wanted in the result
  std::vector<double> rotations;  ///< degrees: these instead of positions
  std::optional<ContactMapInput> map;
};

}  // namespace gearwright
