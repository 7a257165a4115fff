// A pair of gears with circular-arc teeth, mounted on parallel axes.
//
// A convex flank touches a concave flank in a point that moves along the teeth, parallel to the
// axes. There is no transverse path of contact. Contact is therefore continuous only if the teeth
// overlap sufficiently along the face. Each side of a tooth has one point of contact if racks F and
// P have cut the teeth. Teeth with double arcs have two points of contact on each side.
//                                              theory: docs/theory/07-circular-arc.md, 7.4 to 7.7
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/pair/arc_contact.hpp"
#include "gearwright/pair/mounted_gears.hpp"

namespace gearwright {

/// A point at which the leading flanks touch, in the housing frame.
struct ArcPairContact {
  int convex_gear;  ///< 1 or 2
  /// `point` and `normal` are in the housing frame at rotation 0. `normal` points out of gear 1,
  /// and `rotation_offset` refers to the concave gear.
  ArcContact at;
  std::optional<Angle> nominal_theta;  ///< θ at the reference centre distance [T7.9]
};

struct ArcPair : MountedGears {
  ArcPair() = default;                   ///< empty; prevents aggregate initialisation
  double overlap_ratio;                  ///< ε_β  of the common face, with the pitch of gear 1
  std::vector<ArcPairContact> contacts;  ///< empty if the leads of the gears do not match
  double face_for_contact;  ///< least face width at which a point of contact always exists, mm
  std::optional<std::array<Angle, 2>>
      backlash_rotation;       ///< play of each gear while the other gear is held; none without
                               ///< contacts
  double base_backlash = 0.0;  ///< j_bn  mm, along the common normal, at first_contact()

  /// j_n  mm, j_bn/cos θ at the same contact.   Domain: there are contacts
  double normal_backlash() const;
  StatedBacklash stated_backlash() const;  ///< 0 without contact
  double contact_ratio() const;  ///< ε_β times the number of contacts; ε_β without contact
  double contact_ratio_true() const { return contact_ratio(); }
  std::array<double, 2> working_pitch_diameter() const;  ///< 2 a z_i/(z_1 + z_2), mm
  /// Returns the contact that touches first, which has the least angular backlash.
  /// Domain: there are contacts
  const ArcPairContact& first_contact() const;
};

/// The working arcs of the rack that cuts the gear, mm. They include the thickness allowance.
std::vector<WorkingArc> convex_arcs(const Gear& gear);
std::vector<WorkingArc> concave_arcs(const Gear& gear);

/// Permitted differences between the two gears in module and helix angle. They are greater than
/// rounding errors, because a lead may be corrected for errors of the housing.
constexpr double kNearModule = 0.005;              ///< relative difference of the modules
constexpr Angle kNearHelix = Angle::degrees(0.5);  ///< greatest |β_1 + β_2|
constexpr double kSameAsWritten = 1e-9;            ///< relative difference below which two values
                                                   ///< count as equal
constexpr Angle kSamePressureAngle =
    Angle::degrees(0.05);  ///< greatest error of a given pressure angle

/// Mounts two gears. If `distance` is absent, the reference centre distance is used.
///
/// Errors    `gearN.rack` if a gear is an involute gear; `gear2.rack` if no convex arc meets a
///           concave arc; `gearN.rack.dedendum` if a gear does not exist; `gear2.normal_module`,
///           `gear2.helix_angle`, `gear1.helix_angle` (spur); `gearN.rack.…` (the radius of the
///           concave flank) or `pair.center_distance` if no two arcs can touch. The error then
///           gives the values at which two arcs touch. Other faults, such as contacts beyond the
///           usable flanks, are warnings
Result<ArcPair> mount_arcs(Gear gear_1, Gear gear_2, std::optional<double> distance);

}  // namespace gearwright
