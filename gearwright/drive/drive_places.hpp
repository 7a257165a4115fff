// Computes the positions of the axes of a drive, and the order of its gears along the axes.
//
//   slot   axial section of the drive that contains some of the meshes; gears that would overlap in
//          one plane have different slots
//                                              theory: docs/theory/13-drives.md
//
// The drive determines the axes of its planets and of coaxial bodies. All other positions are free,
// and are chosen for a simple drawing. The shafts of a train lie in one line unless the direction
// of a mesh is given. Along the axes, the meshes follow each other in the order of the graph. The
// axis of a rack is the point of its datum line that is nearest to its pinion.
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
  std::vector<Vec2> axes;        ///< axis of each body, mm; for a planet, the axis of copy 0
  std::vector<double> turned;    ///< rad, direction from the carrier's axis to copy 0 of a rider
  std::vector<double> radii;     ///< mm, r_a of an external gear, r_f of a ring, h_a of a rack
  std::vector<int> mesh_slot;    ///< slot of each mesh
  std::vector<SlotRange> slots;  ///< slots of each gear
  int slot_count = 0;
  bool true_scale = false;  ///< true if the positions follow from the geometry of the teeth; false
                            ///< if they follow from the numbers of teeth with the module 1

  /// Returns the axis of copy `copy` of a body in the initial position.
  Vec2 axis_of(const Drive& drive, std::size_t body, int copy) const;
};

/// A mesh or a planet that prevents the assembly of a drive.
struct Misfit {
  std::optional<std::size_t> mesh{};    ///< its axes or its teeth do not fit
  std::optional<std::size_t> planet{};  ///< body without a possible position
  bool any() const { return mesh || planet; }
};

/// Returns the pair of a rack and its pinion. Returns null if the gear is not a rack or has no
/// pair. If a rack has several pinions, the function returns the first pair.
const RackPair* rack_pair_of(const Drive& drive, std::size_t gear);

/// Computes the axes of all bodies and the slots of all gears.
///
/// Errors    `drive.gear` if a rack has several pinions, because their positions along the rack are
///           not known; `drive.mesh` if both gears of a mesh have the same axis, or if the
///           distances of a loop of shafts do not fit together; `drive.body` if a planet has no
///           possible position
/// `misfit`  if not null, gets what does not fit in the last two cases, and is empty otherwise
Result<DrivePlaces> drive_places(const Drive& drive, Misfit* misfit = nullptr);

/// Returns the sentence that a drive cannot be assembled, with the reason. `why` and `misfit` are
/// those of drive_places() or drive_layout().
std::string no_assembly(const Misfit& misfit, const Error& why);

/// Returns the finding that a drive cannot be assembled, or none if nothing is a misfit. Returns
/// none also if the spec does not determine the positions of the axes, so that other positions may
/// be possible.
std::optional<Warning> assembly_fault(const Drive& drive, const Misfit& misfit, const Error& why);

/// Returns a note for each shaft whose axis is within the tip circle of an external gear on another
/// axis. With bearings on both sides of the housing, such a shaft would pass through this gear.
/// Planets and racks are not checked. Returns no notes if `places.true_scale` is false.
std::vector<Warning> shafts_through_gears(const Drive& drive, const DrivePlaces& places);

}  // namespace gearwright
