// Computes the positions of the axes of a drive, and the order of its gears along them.
//
//   slot   axial section of the drive that contains some of the meshes; gears that would overlap in
//          one plane have different slots
//                                              theory: docs/theory/13-drives.md
//
// The drive determines the axes of its planets and of coaxial bodies. All other positions are
// chosen for a simple drawing. The shafts of a train lie in one line unless the direction of a mesh
// is given. Along the axes, the meshes follow each other in the order of the graph. The axis of a
// rack is the point of its datum line that is nearest to its pinion.
#pragma once

#include <numbers>
#include <vector>

#include "gearwright/drive/drive.hpp"

namespace gearwright {

inline constexpr double kTurn = 2 * std::numbers::pi;  ///< one turn, rad

struct SlotRange {
  int first = 0, last = 0;
};

struct DrivePlaces {
  std::vector<Vec2> axes;        ///< axis of each body; for a rider, of its copy 0 mm
  std::vector<double> turned;    ///< direction from the carrier's axis to copy 0 of a rider  rad
  std::vector<double> radii;     ///< r_a of each gear, r_f of a ring, h_a of a rack  mm
  std::vector<int> mesh_slot;    ///< slot of each mesh
  std::vector<SlotRange> slots;  ///< slots of each gear
  int slot_count = 0;
  bool true_scale = false;  ///< true if computed from the teeth, false if from z with module 1

  /// The axis of copy `copy` of a body in the initial position.
  Vec2 axis_of(const Drive& drive, std::size_t body, int copy) const;
};

/// The pair of a rack and its pinion; null if the gear is not a rack or has no pair. If a rack has
/// several pinions, the result is the first pair.
const RackPair* rack_pair_of(const Drive& drive, std::size_t gear);

/// Computes the axes of all bodies and the slots of all gears.
///
/// Errors    `drive.gear` if a rack has several pinions, because their positions along the rack are
///           not known; `drive.mesh` if both gears of a mesh have the same axis, or if a mesh is in
///           a loop of shafts that does not close; `drive.body` if a planet has no possible
///           position
Result<DrivePlaces> drive_places(const Drive& drive);

/// A note for each shaft whose axis is within the tip circle of an external gear on another axis. A
/// shaft that is supported on both sides of the housing would pass through the gear. Planets and
/// racks are not checked.
std::vector<Warning> shafts_through_gears(const Drive& drive, const DrivePlaces& places);

}  // namespace gearwright
