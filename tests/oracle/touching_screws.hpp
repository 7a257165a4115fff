// Two involute screws that touch. This is a slow, independent method for a pair of gears at any
// shaft angle. A gear is represented by an involute that is unwound from the base circle and moved
// along the axis by a screw motion. Gear 2 is turned until the two solids touch. No rack, pitch
// cylinder or line of action is used.
//
//   r_b, β_b   base radius and base helix angle, right hand > 0     s_bt   tooth on the base circle
//   k          turn per mm of axis, r_b k = tan β_b                 r_a    tip radius
//   σ          side of a tooth: +1 its counter-clockwise flank, −1 its clockwise one
//   u          angle that the string is unwound, its length r_b u   z      along the gear's axis
//   φ_1, φ_2   rotations: gear 1 clockwise, gear 2 counter-clockwise, each seen from its own +z
//   Σ, a       shaft angle, centre distance                         n      tooth number, see below
//
// Housing.  Axis 1 is z; axis 2 passes (a, 0, 0) along (0, sin Σ, cos Σ). At φ_1 = φ_2 = 0, in each
// gear's section z = 0, tooth 0 of gear 1 points at +x and space 0 of gear 2 at −x. Tooth n of gear
// 1 and space n of gear 2 are there n pitches later. n is any integer, not taken modulo z: on a
// worm, the next turn of the thread is tooth n + z.
//
// Leading flanks (σ = −1 on both gears) touch when gear 1 drives. Gear 2 may then run ahead but not
// fall behind, so φ_2 is the greatest rotation at which any point of gear 1 lies on a flank of gear
// 2. For trailing flanks (σ = +1) it is the least. Two methods find it, and they must agree: a
// search over flank 1, clipped to both tip cylinders, that computes for each point only when flank
// 2 passes it; and, if the search ends inside both flanks, the solution of "same point, parallel
// normals" started there.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <ostream>

namespace gearwright::oracle {

/// An external gear described by its flanks; mm and rad.
struct Screw {
  int teeth = 0;                ///< z ≥ 1
  double base_radius = 0.0;     ///< r_b > 0
  double base_thickness = 0.0;  ///< s_bt > 0, arc of the base circle in the transverse section
  double base_helix = 0.0;      ///< β_b  |β_b| < π/2
  double tip_radius = 0.0;      ///< r_a > r_b, at most the radius at which the flanks of a tooth
                                ///< meet
};

struct ScrewPair {
  Screw first, second;
  double center_distance = 0.0;  ///< a  mm, greater than both tip radii
  double shaft_angle = 0.0;      ///< Σ  rad, |Σ| < π, signed
  /// If half_face > 0, gear 1 exists only for |z| ≤ half_face. If it is 0, only the section z = 0
  /// is used.
  double half_face = std::numeric_limits<double>::infinity();
};

enum class Side { leading = -1, trailing = +1 };

/// The parts that touch: both flanks, or the edge at which one of them ends. `base_1`, `base_2`:
/// the involute ends at its base circle, and the curve beyond it is not known here. `unsettled`:
/// the two methods contradict each other, so there is no result.
enum class Where { flanks, tip_1, tip_2, base_1, base_2, face_1, unsettled };

struct Touch {
  double rotation_2 = 0.0;  ///< φ_2  rad; solved if `where` is flanks, otherwise found by the
                            ///<      search
  double searched_2 = 0.0;  ///< φ_2  rad, from the search alone
  /// Housing, mm. On parallel axes, one point of the line of contact.
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, out of gear 1
  int tooth = 0;                                     ///< n
  Where where = Where::flanks;
  double string_1 = 0.0, string_2 = 0.0;  ///< r_b u of the touching point on each flank, mm
  double residual = 0.0;  ///< mm, the greater of two values: the distance of the two solved
                          ///< points, and r_b1 |n_1 × n_2|
  double margin = 0.0;    ///< mm, string length (or width) from the nearest end of a flank
};

/// A point of the flank σ of tooth 0, in the gear's frame: the string's end.
/// Units     mm, rad        Domain    u ≥ 0
Eigen::Vector3d flank_point(const Screw& gear, int sigma, double u, double z);

/// Unit normal there, out of the material.
Eigen::Vector3d flank_normal(const Screw& gear, int sigma, double u, double z);

/// The contact of tooth n of gear 1 in space n of gear 2, without the other teeth. Absent if no
/// part of the flank lies within the tip cylinder and outside the base cylinder of gear 2.
/// Units     mm, rad
/// Accuracy  rotation 1e-13 rad, at an edge too; point 1e-12 mm over sin² Σ, at an edge 1e-7 of the
///           flank. A corner of two tips is overlooked if it is smaller than 1/200 of the part of
///           the flank that lies inside the other gear
/// Throws    std::invalid_argument for numbers outside the domains above, or parallel axes whose
///           helices do not fit
std::optional<Touch> touch_of_tooth(const ScrewPair& pair, double rotation_1, Side side, int tooth);

/// The contact of the two solids. Of all teeth within reach, it is that of the tooth that stops
/// gear 2. If several teeth touch at once, it is the contact whose point lies farthest from the
/// ends of the flanks.
std::optional<Touch> touch(const ScrewPair& pair, double rotation_1, Side side);

/// The angle by which gear 2 can turn while gear 1 is fixed, rad. It is negative if the solids
/// overlap in every position.
std::optional<double> play(const ScrewPair& pair, double rotation_1);

std::ostream& operator<<(std::ostream& os, Where where);

}  // namespace gearwright::oracle
