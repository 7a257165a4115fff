// Computes an assembled drive: position and angle of every copy of every gear, such that all teeth mesh,
// and its motion.
//
//   θ_a, θ_b   direction of the contact as seen from the axes of gears a and b
//   φ          angle of a gear's x axis, the centre line of its tooth 0
//
// A tooth of one gear is opposite a space of the other, in the middle of the backlash:
//
//   z_a (θ_a − φ_a) + z_b (θ_b − φ_b) ≡ π  mod 2π,  z < 0 of a ring                       [T13.15c]
//                                              theory: docs/theory/13-drives.md
#pragma once

#include <optional>
#include <vector>

#include "gearwright/drive/drive_places.hpp"

namespace gearwright {

struct PlacedGear {
  std::size_t gear;  ///< index in the graph
  int copy;          ///< of its body, from 0
  Vec2 axis;         ///< mm
  double angle;      ///< φ in the middle of its face  rad
  double height;     ///< z of the middle of its face  mm
};

/// A section across the axes with the gears in it.
struct DriveSection {
  double height;                   ///< z  mm
  std::vector<std::size_t> gears;  ///< indices of DriveLayout::gears
};

struct DriveLayout {
  DrivePlaces places;
  std::vector<PlacedGear> gears;       ///< every copy, by gear and then by copy
  std::vector<DriveSection> sections;  ///< one for each slot

  /// φ of a placed gear at a height.
  double angle_at(const Drive& drive, std::size_t placed, double height) const;
};

/// Errors    as drive_places; a drive without teeth; planets whose teeth do not meet
Result<DriveLayout> drive_layout(const Drive& drive);

/// The same layout after a number of turns of the first input.
///
/// Domain    a drive whose speeds are known: one input, or speeds of all (contract)
DriveLayout turned(const Drive& drive, DriveLayout layout, double input_turns);

/// Least number of turns of the input after which the drive looks the same: gears have moved by
/// whole teeth, and equally spaced planets to the position of the next one. None with several
/// inputs, or if there is no such number.
std::optional<Rational> turns_until_alike(const Drive& drive);

}  // namespace gearwright
