// Describes two mounted gears for the contact analysis. Their touching flanks are divided into
// smooth patches. A common frame N allows the same formulas for all kinds of pair.
//
//   Housing f   the frame of kinematics/pose.hpp; errors tilt and shift axis 1, and ΔC moves axis 2
//   World N     the frame in which gear 2 turns counter-clockwise, and gear 1 touches the clockwise
//               side of its tooth
//               external pair, gear 1 drives    N = f
//               internal pair                   N = f with −y; both gears turn in the same sense
//               gear 2 drives                   half a turn about x, (y, z) → (−y, −z), and both
//                                               rotations change sign
//                                               theory: docs/theory/08-contact.md, [T8.11]…[T8.13]
//
// Tooth pair k repeats the motion of pair 0, k pitches of gear 1 later.
#pragma once

#include <array>
#include <numbers>
#include <optional>
#include <vector>

#include "gearwright/contact/gap_field.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/pair/rack_pair.hpp"

namespace gearwright {

/// All errors of mounting and of cutting. Order and signs: docs/spec.md, [errors].
struct ContactErrors {
  double center_distance = 0.0;         ///< ΔC  mm
  Angle crossing{};                     ///< Δγ  about the centre line
  Angle intersecting{};                 ///< Δδ  in the plane of the axes
  double axial = 0.0;                   ///< Δz  mm
  std::array<double, 2> helix_twist{};  ///< κ   rad/mm: the section at z is turned by κz
  std::array<Angle, 2> cutter_lead{};   ///< Δλ  deviation of the lead angle of the cutter

  bool operator==(const ContactErrors&) const = default;
};

/// Returns the errors of a mounting after reflection in the plane z = 0. The errors of the teeth do
/// not change, because both halves of a double-helical gear have the same errors.
ContactErrors mirrored(const ContactErrors& errors);

struct ContactGear {
  const Gear* gear = nullptr;
  /// Material removed from the right (y < 0) and from the left flank; null if none is removed.
  std::array<const RemovalField*, 2> removal{};
};

struct ContactMount {
  double center_distance = 0.0;  ///< a  mm, without errors
  /// σ Σ, where σ is −1 if gear 2 is internal, otherwise 1. Axis 2 has the direction (0, sin σΣ,
  /// cos σΣ).
  Angle axis_angle{};
  bool gear2_drives = false;
  ContactErrors errors;
  /// z of the middle of each face, mm. It is 0 except for a half of a double-helical gear. Errors
  /// tilt axis 1 about its point at z = 0. At rotation 0, pair 0 is in mesh in the section z =
  /// middle[0].
  std::array<double, 2> middle{};
  /// True if root fillets and rounded tips are included. The analysis then also finds tips that
  /// touch a fillet before the flanks touch. Rounded tips of modified flanks are not included,
  /// because the removal of material is defined on the flank only.
  ///
  /// Domain  recut_outline() returns an outline for each gear whose cutter has a changed lead angle
  bool fillets = false;
};

class ContactPair {
 public:
  /// Domain  gear 1 is external, both gears exist and have a flank; the numbers of teeth are
  ///         arbitrary (contract)
  ContactPair(const ContactGear& gear_1, const ContactGear& gear_2, const ContactMount& mount);
  /// Makes the pair of a pinion and its rack. The rack has no modifications and no errors of its
  /// teeth. In place of the rotation of gear 2, results contain the travel of the rack divided by
  /// the reference radius of the pinion.
  /// [T8.29]
  ///
  /// Domain  an axis angle of 0, no fillets, equal `middle` of both faces, no errors of the teeth
  ///         of the rack (contract)
  ContactPair(const ContactGear& pinion, const RackGeometry& rack, const ContactMount& mount);

  const std::vector<FlankPatch>& patches(int gear) const { return patches_[gear - 1]; }
  const RelativeMount& mount() const { return relative_; }
  GapField field(const FlankPatch& one, const FlankPatch& two) const {
    return {one, two, relative_, ratio_, rotation_sign_, rack_radius_};
  }
  double ratio() const { return ratio_; }                  ///< |z1/z2|; 1 for a rack
  double pitch() const { return pitch_; }                  ///< 2π/|z1|  rad
  double rotation_sign() const { return rotation_sign_; }  ///< gear 1 in frame N; −1 is clockwise
  double mesh_azimuth() const { return (1.0 - side_) * std::numbers::pi / 2; }
  double reach() const { return reach_; }
  bool is_rack() const { return rack_radius_ > 0.0; }
  /// The reference radius of the pinion of a rack, mm; 0 for two gears.
  double rack_radius() const { return rack_radius_; }
  /// The diameter at u = ln ρ of a gear, mm. For a rack, the height above the datum line at u =
  /// height/r.
  double diameter(int gear, double u) const;
  double u_at(int gear, double diameter) const;  ///< the inverse of diameter()
  bool gear2_drives() const { return place_.gear2_drives; }
  const ContactMount& place() const { return place_; }
  double normal_pressure_angle() const { return alpha_n_; }  ///< α_n of the rack of gear 1, rad

  /// Converts a rotation of gear 1 between the housing and the frame N, in both directions.
  double to_world(double rotation1) const { return place_.gear2_drives ? -rotation1 : rotation1; }
  /// Converts a point (w1, z) of gear 1, before mounting, to the housing frame.
  Vec3 in_housing(const Complex& w1, double z) const;
  /// Converts a vector from the frame N to the housing frame.
  Vec3 in_housing(const FreeVector<World>& v) const;
  /// Returns `direction`, given in the housing, after errors have tilted it together with axis 1.
  Vec3 tilted(const Vec3& direction) const;
  /// Rotates vectors from the frame of gear 1, before mounting, to the frame N.
  const LinearMap<World, Axis1>& tilt() const { return tilt_; }
  /// σ, the side of gear 2: −1 for an internal pair, whose frame N is mirrored (−y), otherwise 1.
  double side() const { return side_; }
  /// −1 if z in the frame N is −z in the housing, otherwise 1.
  double turned() const { return place_.gear2_drives ? -1.0 : 1.0; }
  /// z of the middle of a face in the frame N, mm.
  double middle(int gear) const { return turned() * place_.middle[gear - 1]; }
  /// Radius of the end of the root fillet, mm; none without a fillet, or if `fillets` is false.
  std::optional<double> root_end(int gear) const { return root_end_[gear - 1]; }
  /// κ in the frame N, rad/mm, for f_Hβ = 1 mm on the reference cylinder over the face width.
  double twist_per_slope(int gear) const { return slope_unit_[gear - 1]; }

 private:
  // `twist` contains the twist of the lead, and the additional twist due to the lead error.
  void add_patches(int which, const ContactGear& gear, const std::array<double, 2>& twist,
                   double center, double side, bool right);
  void set_mount();

  ContactMount place_;
  double side_;
  double alpha_n_;
  double ratio_, pitch_, rotation_sign_, reach_ = 0.0, rack_radius_ = 0.0;
  std::array<std::vector<FlankPatch>, 2> patches_;
  RelativeMount relative_;
  LinearMap<World, Axis1> tilt_;
  Point<World> lift_;                   // the middle of face 1
  std::array<double, 2> slope_unit_{};  // κ in the frame N, rad/mm, per mm of f_Hβ
  std::array<std::optional<double>, 2> root_end_;
};

}  // namespace gearwright
