// Computes the positions of the axes of a drive, and the order of its gears along them.
//
//   slot   a section of the axes that contains some of the meshes; gears that would overlap in one
//          plane have different slots
//                                              theory: docs/theory/13-drives.md
//
// The drive itself determines the axes of its planets and the coaxial bodies. The rest is chosen
// for a simple drawing: shafts of a train lie in one line, unless a mesh has an angle, and the
// meshes follow each other along the axes in their order.
#pragma once

#include <numbers>
#include <vector>

#include "gearwright/drive/drive.hpp"

namespace gearwright {

inline constexpr double kTurn = 2 * std::numbers::pi;  ///< rad

struct SlotRange {
  int first = 0, last = 0;
};

struct DrivePlaces {
  std::vector<Vec2> axes;        ///< of each body; for a rider, of its copy 0  mm
  std::vector<double> turned;    ///< direction of a rider's copy 0 from its carrier's axis  rad
  std::vector<double> radii;     ///< r_a of each gear, r_f of a ring  mm
  std::vector<int> mesh_slot;    ///< of each mesh
  std::vector<SlotRange> slots;  ///< of each gear
  int slot_count = 0;
  bool true_scale = false;  ///< true if computed from teeth, false if from tooth numbers with m = 1

  /// The axis of copy `copy` of a body in the initial position.
  Vec2 axis_of(const Drive& drive, std::size_t body, int copy) const;
};

/// Errors    `drive.gear` of a rack; `drive.mesh` whose axes cannot be placed: coaxial axes, or a
///           loop of shafts that does not close; planets without a possible position
Result<DrivePlaces> drive_places(const Drive& drive);

}  // namespace gearwright
