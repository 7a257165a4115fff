// Two mounted gears, with the data that pairs of all kinds of teeth have in common.
//
// Gear 1 drives and turns clockwise seen from +z. At rotation 0, tooth 0 of gear 1 and space 0 of
// gear 2 lie on the centre line, at the mesh. The housing frame is described in
// kinematics/pose.hpp.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/gear/gear.hpp"
#include "gearwright/kinematics/pose.hpp"
#include "gearwright/pair/collision.hpp"
#include "gearwright/pair/stated_backlash.hpp"

namespace gearwright {

struct MountedGears {
  MountedGears() = default;  ///< empty; prevents aggregate initialisation
  std::array<Gear, 2> gears{};
  double center_distance = 0.0;            ///< a    mm
  double reference_center_distance = 0.0;  ///< a_d  mm
  Angle shaft_angle;                       ///< Σ    0 on parallel axes
  std::array<double, 2> tip_clearance{};   ///< c    mm: tip 1 to root 2, tip 2 to root 1
  std::optional<double> speed_rpm{};       ///< n_1  1/min, if given
  /// Collisions in which the bodies overlap although gear 2 is in the middle of its play, the
  /// deepest first. None if the overlap was not computed, because the leads differ or the cutter of
  /// an internal gear is unknown. On crossed axes, only tips are compared with the mating gear
  std::optional<std::vector<Collision>> overlap{};
  /// Contacts of parts other than the flanks, without overlap. During such a contact, the
  /// transmission ratio is not constant.
  std::vector<Collision> beyond_flank{};
  /// The angle through which gear 2 can turn without a collision. It is at most the play of the
  /// flanks. It is < 0 if the bodies overlap in every position. None if the angle was not computed,
  /// or if a tip extends below the mating root circle
  std::optional<Angle> free_play{};
  std::vector<Warning> warnings;

  bool crossed() const { return shaft_angle.rad() != 0.0; }
  /// True for an internal pair on crossed axes. The flanks of such a pair overlap beside the line
  /// of action, and its tips are closest to the roots at the ends of the faces. [T4.35], [T4.37]
  bool crossed_inside() const { return side() < 0.0 && shaft_angle != Angle(); }
  double side() const { return gears[1].side(); }  ///< σ  +1 external pair, −1 internal
  /// Returns the whole face width, mm, of gears whose teeth are `face` mm wide. For double-helical
  /// gears, the result includes both halves and the wider of the gaps of both gears.
  double whole_face(double face) const;
  /// σ Σ. Axis 2 has the direction (0, sin σΣ, cos σΣ). [T1.8]
  Angle axis_angle() const { return side() * shaft_angle + Angle(); }  // without −0
  double gear_ratio() const;  ///< z2/z1, negative for internal pairs
  /// Poses of the gear frames in the housing at rotation 0. [T1.5]
  Pose<Housing, Gear1> pose_1() const;
  Pose<Housing, Gear2> pose_2() const;
};

}  // namespace gearwright
