// Computes the layout of an assembled drive, and the motion of the drive. In the layout, the
// positions and angles of the gears are such that all teeth mesh.
//
//   θ_a, θ_b   direction of the contact as seen from the axes of gears a and b
//   φ          angle of a gear's x axis, the centre line of its tooth 0
//
// A tooth of one gear is opposite a space of the mating gear, in the middle of the backlash:
//
//   z_a (θ_a − φ_a) + z_b (θ_b − φ_b) ≡ π  mod 2π,   z < 0 for a ring                [T13.15c]
//
// A rack counts as a gear with z_b = 1 and θ_b = 0. It is displaced by φ_b/2π pitches along the y
// axis of its frame (pair/rack_pair.hpp).
//                                              theory: docs/theory/13-drives.md
#pragma once

#include <optional>
#include <vector>

#include "gearwright/drive/drive_places.hpp"

namespace gearwright {

struct PlacedGear {
  std::size_t gear;  ///< index in the graph
  int copy;          ///< number of the copy of the body, from 0
  Vec2 axis;         ///< mm, position of the axis; for a rack, the middle of the datum line
  double angle;      ///< rad, φ in the middle of the face; for a rack, the direction to the pinion
  double height;     ///< mm, z of the middle of the face
};

/// A plane perpendicular to the axes, and the gears that it cuts.
struct DriveSection {
  double height;                   ///< z  mm
  std::vector<std::size_t> gears;  ///< indices of DriveLayout::gears
};

struct DriveLayout {
  DrivePlaces places;
  std::vector<PlacedGear> gears;       ///< all copies, in the order of gear and copy
  std::vector<DriveSection> sections;  ///< one section for each slot

  /// Returns φ of a placed gear at a height.
  double angle_at(const Drive& drive, std::size_t placed, double height) const;
  /// Returns the axis of a placed gear, mm, or the middle of a rack's datum line at the height.
  Vec2 axis_at(const Drive& drive, std::size_t placed, double height) const;
};

/// Computes the layout of a drive in the initial position.
///
/// Errors    as drive_places(); `drive.gear` if the module of a gear is unknown; `drive.mesh` or
///           `drive.body` if teeth do not mesh; `drive.mesh` if gears cannot be made or mounted
/// `misfit`  as for drive_places(); if the teeth do not mesh, gets their mesh or planet
Result<DriveLayout> drive_layout(const Drive& drive, Misfit* misfit = nullptr);

/// Returns a finding for each mesh whose gears share less of their faces in the layout than the
/// results assume. The cause is a gear that meshes with gears in several slots and is too narrow.
std::vector<Warning> partial_faces(const Drive& drive, const DriveLayout& layout);

/// Returns the unit vector along a placed rack. If the pinion turns counter-clockwise, the rack
/// moves opposite to this vector.
Vec2 along_rack(const PlacedGear& rack);

/// Returns the layout after a number of turns of the first input.
///
/// Domain    one input, or given speeds of all inputs (contract)
DriveLayout turned(const Drive& drive, DriveLayout layout, double input_turns);

/// Returns the least number of turns of the input after which the drive looks the same. All gears
/// have then moved by whole teeth, but equally spaced planets may have changed places with each
/// other. Returns none with several inputs, or if there is no such number.
std::optional<Rational> turns_until_alike(const Drive& drive);

}  // namespace gearwright
