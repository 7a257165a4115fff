// Two gears in their places: what every pair has, whatever its teeth.
//
// Gear 1 drives, turning clockwise seen from +z; at rest tooth 0 of gear 1 and space 0 of gear 2
// stand on the centre line at the mesh. Housing frame: kinematics/pose.hpp.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/gear/gear.hpp"
#include "gearwright/kinematics/pose.hpp"
#include "gearwright/pair/collision.hpp"

namespace gearwright {

struct MountedGears {
  MountedGears() = default;  ///< empty, and no aggregate: mount() makes it
  std::array<Gear, 2> gears{};
  double center_distance = 0.0;            ///< a    mm
  double reference_center_distance = 0.0;  ///< a_d  mm
  Angle shaft_angle;                       ///< Σ    0 on parallel axes
  std::array<double, 2> tip_clearance{};   ///< c    mm: tip 1 to root 2, tip 2 to root 1
  std::optional<double> speed_rpm{};       ///< n_1  1/min, where one is given
  /// Where the bodies would share space, in the middle of the play, deepest first. None: not looked
  /// for (unequal leads, an internal gear whose cutter nobody knows). On crossed axes: tips in roots
  std::optional<std::vector<Collision>> overlap{};
  /// Contact off the flanks while nothing overlaps: the ratio is not constant then.
  std::vector<Collision> beyond_flank{};
  /// The play of gear 2 in which nothing strikes, that of the flanks or less; < 0: there is no place
  /// without overlap. None: not looked for, or a tip stands in a root
  std::optional<Angle> free_play{};
  std::vector<Warning> warnings;

  bool crossed() const { return shaft_angle.rad() != 0.0; }
  double side() const { return gears[1].side(); }  ///< σ  +1 external pair, −1 internal
  double gear_ratio() const;                       ///< z2/z1, negative for internal pairs
  /// Gear frames in the housing at rotation 0. [T1.5]
  Pose<Housing, Gear1> pose_1() const;
  Pose<Housing, Gear2> pose_2() const;
};

}  // namespace gearwright
