// Two mounted gears for the contact analysis: their touching flanks cut into smooth patches, in a
// frame N in which all cases are equal.
//
//   Housing f   kinematics/pose.hpp; errors tilt and shift axis 1, ΔC moves axis 2
//   World N     gear 2 turns counter-clockwise and is touched on the clockwise side of its tooth
//               external pair, gear 1 drives    N = f
//               internal pair                   N = f with −y: both gears turn the same way
//               gear 2 drives                   half a turn about x, (y, z) → (−y, −z), and both
//                                               rotations change sign
//                                               theory: docs/theory/08-contact.md, [T8.11]…[T8.13]
//
// Tooth pair k is at the place of pair 0 k pitches of gear 1 earlier; k runs over all integers.
#pragma once

#include <array>
#include <numbers>
#include <optional>
#include <vector>

#include "gearwright/contact/gap_field.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// All errors of mounting and of cutting. Order and signs: docs/spec.md, [errors].
struct ContactErrors {
  double center_distance = 0.0;         ///< ΔC  mm
  Angle crossing{};                     ///< Δγ  about the centre line
  Angle intersecting{};                 ///< Δδ  in the plane of the axes
  double axial = 0.0;                   ///< Δz  mm
  std::array<double, 2> helix_twist{};  ///< κ   rad/mm: section z turned by κz
  std::array<Angle, 2> cutter_lead{};   ///< Δλ  cut with another lead angle

  bool operator==(const ContactErrors&) const = default;
};

/// The errors of a mounting as its mirror image in the plane z = 0 has them. Errors of the teeth
/// belong to each half of a double-helical gear in the same way and do not change.
ContactErrors mirrored(const ContactErrors& errors);

struct ContactGear {
  const Gear* gear = nullptr;
  /// Removal from the right (y < 0) and the left flank; null if there is none.
  std::array<const RemovalField*, 2> removal{};
};

struct ContactMount {
  double center_distance = 0.0;  ///< a  mm, without errors
  Angle axis_angle{};            ///< σ Σ: axis 2 lies along (0, sin, cos) of it
  bool gear2_drives = false;
  ContactErrors errors;
  /// z of the middle of each face, mm: not 0 for a half of a double-helical gear. Errors tilt axis 1
  /// about its point at z = 0, and at rotation 0 the section at middle[0] is the one of pair 0.
  std::array<double, 2> middle{};
  /// Root fillets and rounded tips are included, so that contact of a fillet before the flanks is
  /// found. Tips of modified flanks are not included, because their removal does not continue
  /// there.   Domain: a changed lead only if recut_outline can compute the root
  bool fillets = false;
};

class ContactPair {
 public:
  /// Domain  gears that exist, with a flank; |z1|, |z2| any (contract)
  ContactPair(const ContactGear& gear_1, const ContactGear& gear_2, const ContactMount& mount);

  const std::vector<FlankPatch>& patches(int gear) const { return patches_[gear - 1]; }
  const RelativeMount& mount() const { return relative_; }
  double ratio() const { return ratio_; }                  ///< |z1/z2|
  double pitch() const { return pitch_; }                  ///< 2π/|z1|  rad
  double rotation_sign() const { return rotation_sign_; }  ///< of gear 1 in N
  double mesh_azimuth() const { return internal_ ? std::numbers::pi : 0.0; }
  double reach() const { return reach_; }
  bool internal() const { return internal_; }
  bool gear2_drives() const { return place_.gear2_drives; }
  const ContactMount& place() const { return place_; }
  double normal_pressure_angle() const { return alpha_n_; }  ///< of gear 1's straight rack, rad

  /// A rotation of gear 1 in N, and the reverse.
  double to_world(double rotation1) const { return place_.gear2_drives ? -rotation1 : rotation1; }
  /// A point (w1, z) of gear 1 before mounting, in the housing frame.
  Vec3 in_housing(const Complex& w1, double z) const;
  /// A direction of N in the housing frame.
  Vec3 direction_in_housing(const Vec3& v) const;
  /// Rotates the directions of gear 1 before mounting into N.
  const Mat3& tilt() const { return tilt_; }
  double mirror() const { return internal_ ? -1.0 : 1.0; }            ///< of y, in N
  double turned() const { return place_.gear2_drives ? -1.0 : 1.0; }  ///< of z, in N
  /// z of the middle of a face, mm, in N.
  double middle(int gear) const { return turned() * place_.middle[gear - 1]; }
  /// Radius at which the root fillet ends, mm; none without ContactMount::fillets or without a
  /// fillet.
  std::optional<double> root_end(int gear) const { return root_end_[gear - 1]; }
  /// κ in N per mm of f_Hβ at the reference cylinder over the face.
  double twist_per_slope(int gear) const { return slope_unit_[gear - 1]; }

 private:
  // `twist` is that of the lead, and that of the lead error in addition.
  void add_patches(int which, const ContactGear& gear, const std::array<double, 2>& twist,
                   double center, double side, bool right);
  void set_mount();

  ContactMount place_;
  bool internal_;
  double alpha_n_;
  double ratio_, pitch_, rotation_sign_, reach_ = 0.0;
  std::array<std::vector<FlankPatch>, 2> patches_;
  RelativeMount relative_;
  Mat3 tilt_ = Mat3::Identity();
  Vec3 lift_ = Vec3::Zero();            // of the middle of face 1, in N
  std::array<double, 2> slope_unit_{};  // κ in N per mm of f_Hβ
  std::array<std::optional<double>, 2> root_end_;
};

}  // namespace gearwright
