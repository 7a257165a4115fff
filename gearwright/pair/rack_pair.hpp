// A pinion and a rack, which is the exact limit of a parallel pair for z2 → ∞.
//
//   H, H_0    distance from the pinion axis to the datum line of the rack, as mounted and without
//             backlash   mm
//   r, r_b    reference and base radius of the pinion   mm      α_n, α_t   pressure angles
//   g         position along the line of action from the pitch point, > 0 in recess   mm
//   g_a, g_f  lengths of approach and recess   mm       p_t, p_bt   transverse pitches   mm
//   ζ         specific sliding                    theory: docs/theory/02-involute-and-pair.md, 2.10
//
// The pitch point is on the reference circle at every H, so the working pressure angle is always
// α_t. The pinion drives.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/gear/gear.hpp"
#include "gearwright/generation/outline.hpp"
#include "gearwright/kinematics/pose.hpp"
#include "gearwright/pair/efficiency.hpp"
#include "gearwright/pair/stated_backlash.hpp"

namespace gearwright {

/// A rack as a part. The teeth have the profile of the basic rack of the pinion.
struct RackBar {
  std::optional<int> teeth{};            ///< n; if absent, see RackGeometry::teeth
  std::optional<double> space{};         ///< mm, length in which these whole teeth fit, if given
  std::optional<double> face_width{};    ///< b    mm; by default the face width of the pinion
  std::optional<double> height{};        ///< mm, from the back of the rack to the datum line; by
                                         ///< default dedendum + 3 modules
  double thickness_allowance = 0.0;      ///< E_sn mm at the datum line, < 0 thins the teeth
  std::optional<double> pin_diameter{};  ///< D_M mm of the usual measuring pin; see usual_pin()
};

/// The geometry of a rack, from its pinion and its RackBar.
struct RackGeometry {
  RackBar bar;
  int teeth;                    ///< n; the default is odd, at least 15, and at least z of the
                                ///< pinion
  double height;                ///< mm, from the back of the rack to the datum line
  double normal_module;         ///< m_n  mm
  Angle helix_angle;            ///< β    with the hand opposite to the pinion
  Angle normal_pressure_angle;  ///< α_n
  double face_width;            ///< b    mm
  double normal_pitch;          ///< p_n  mm
  double transverse_pitch;      ///< p_t  mm, along the travel
  double addendum;              ///< h_a  mm, above the datum line
  double dedendum;              ///< h_f  mm, below the datum line
  double thickness;             ///< s_n  mm, normal, at the datum line
  double fillet_radius;         ///< ρ_f  mm, in the normal section; at most the full radius
  std::optional<double> length() const;  ///< n p_t  mm, with half a space at both ends; none if
                                         ///< RackBar::teeth is absent
  /// The depth below the datum line at which the straight flank joins its fillet, mm. [T2.39]
  double form_depth() const;
};

struct RackPair {
  RackPair() = default;  ///< empty; prevents aggregate initialisation
  Gear pinion;
  RackGeometry rack;
  double center_distance;                ///< H    mm
  double backlash_free_center_distance;  ///< H_0  mm, of the teeth as cut
  double travel_per_turn;                ///< π m_t z  mm
  double approach,
      recess;  ///< g_a, g_f  mm, up to the tips; < 0 if a tip is short of the pitch point
  double true_approach, true_recess;  ///< approach and recess, clipped to the usable flanks
  double overlap_ratio;               ///< ε_β over the common face
  double base_pitch;                  ///< p_bt  mm
  std::array<double, 2>
      tip_clearance;  ///< c    mm: pinion tip to rack root, rack tip to pinion root
  std::optional<double>
      contact_root_diameter;  ///< d_Nf of the pinion  mm; none if contact with the rack tip extends
                              ///< beyond the base tangent point
  std::optional<double> form_clearance;  ///< (d_Nf − d_Ff)/2  mm
  std::optional<double> speed_rpm;       ///< n_1  1/min
  std::optional<Efficiency> efficiency;  ///< present if a coefficient of friction is given and
                                         ///< contact is continuous
  std::vector<Warning> warnings;

  double mounting_distance() const { return center_distance + rack.height; }  ///< mm
  /// Poses of pinion and rack in the housing at rotation 0. The comment at rack_outline() defines
  /// the frame of the rack. Tooth 0 of the pinion points into the space of the rack that is nearest
  /// to the middle of the rack.
  Pose<Housing, Gear1> pose_1() const { return {}; }
  Pose<Housing, Gear2> pose_2() const;
  double transverse_contact_ratio() const;  ///< ε_α, 0 without contact
  double true_contact_ratio() const;        ///< ε_α on the usable flanks
  /// The parts of true_contact_ratio() before and after the pitch point.
  std::array<double, 2> approach_and_recess() const;
  /// Returns g at the start of contact, mm. Contact starts at A. If the pinion is undercut, contact
  /// starts at the beginning of the clipped path.
  double contact_start() const;
  double normal_backlash() const;  ///< j_n  mm
  StatedBacklash stated_backlash() const;
  double base_backlash() const;             ///< j_bn mm
  double circumferential_backlash() const;  ///< j_t  mm, along the rack
  /// Returns ζ of pinion and rack for a contact at g. ζ of the pinion is empty at the base tangent
  /// point and beyond this point.
  std::array<std::optional<double>, 2> specific_sliding(double g) const;
};

/// Mounts a pinion and a rack. Faults of the mesh are warnings.
///
/// Formula   theory page 2, [T2.36]…[T2.41] and [T2.46]
/// Domain    H > 0 (contract)
/// Errors    `gear1.teeth` for an internal gear; `gear1.rack` for circular arcs; the errors of
///           Gear::why_not() if the pinion has no tooth; `gear2.face_width` outside the limits of a
///           gear; `gear2.height` if the back is not below the roots or is beyond 100 000 modules;
///           `gear2.thickness_allowance` if the rack has no tooth or no space
Result<RackPair> mount_rack(Gear pinion, const RackBar& bar,
                            std::optional<double> center_distance = {},
                            std::optional<double> speed_rpm = {},
                            std::optional<double> friction = {});

// The outline of the teeth of a rack in the transverse section, in the form of a gear's outline.
//
//   x     height above the datum line, mm       y   along the travel, mm
//   s_n   thickness at the datum line, in the normal section, mm
//   ρ_f   radius of the root fillet, in the normal section, mm
//   n     y cos β, the coordinate y of the normal section, mm
//                                     theory: docs/theory/02-involute-and-pair.md, [T2.45]
//
// Frame of a rack: the origin is on the datum line, in the middle of the length and of the face. x
// points from the back towards the teeth, and z points along the face. In the section z = 0, tooth
// k of N is centred at y = (k − (N − 1)/2) p_t. In the section at the height z, it is displaced by
// z tan β.
//
//   Laws  (1) the first point is the middle of the space, y = p_t/2, and the last point is the
//             middle of the tooth, y = 0
//         (2) the normal section, (x, y cos β), is the section of the spur rack with the same m_n
//         (3) the flank is straight, and the flank of the pinion is the envelope of this flank

/// Half a tooth from root to tip. The x axis is the centre line of the tooth. The member `teeth` of
/// the outline is RackGeometry::teeth.
///
/// Formula   [T2.45]: land at x = −h_f, circle of radius ρ_f (in the transverse section an
///           ellipse), line n = s_n/2 − x tan α_n, land at x = h_a
/// Units     mm
/// Accuracy  closed form
/// Errors    `gear2.thickness_allowance` if it makes the teeth pointed or closes the spaces
Result<Outline> rack_outline(const RackGeometry& rack);

}  // namespace gearwright
