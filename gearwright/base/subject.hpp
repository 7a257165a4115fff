// The gear and the member that an error concerns, as data for decisions in code.
//
// The field of an error is a text for users, "gear1.tip_fillet.end_radius". If the value of the
// field was computed from other inputs, code attributes the error to one of these inputs. For this
// purpose, the table in subject.cpp translates the field to a gear and a member. No other code
// compares fields.
#pragma once

#include <string_view>

namespace gearwright {

/// The members of a gear that code distinguishes.
enum class GearMember {
  none,                 ///< the field names the gear as a whole, "gear1", or is empty
  other,                ///< any other field
  teeth,                ///< number of teeth
  normal_module,        ///< m_n
  helix_angle,          ///< β
  profile_shift,        ///< x
  thickness_allowance,  ///< E_sn
  face_width,           ///< b
  tip_diameter,         ///< d_a
  tip_end_radius,       ///< radius at which a tip fillet ends
  cutter,               ///< pinion cutter and generating centre distance
  bore,                 ///< diameter of the bore
  keyway,               ///< width or depth of the keyway
  center_distance       ///< a, a member of the pair and not of a gear
};

struct Subject {
  int gear = 0;  ///< 1 or 2; 0 if the field names no gear
  GearMember member = GearMember::none;
  bool operator==(const Subject&) const = default;
};

/// The subject of a field, {1, tip_end_radius} for "gear1.tip_fillet.end_radius".
Subject subject_of(std::string_view field);

}  // namespace gearwright
