// Describes a touch: its position on both gears and in the housing, its kind, and the curvatures of
// the gap at the touch.
//
//   T         gap field of two flanks (gap_field.hpp)     TE   greatest T, the transmission error
//   k1 ≤ k2   curvatures of the gap, 1/mm: principal values of K2 − K1
//   δ         thickness of the marking compound, mm
//                                    theory: docs/theory/08-contact.md, [T8.15]…[T8.17]
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "gearwright/contact/transmission.hpp"

namespace gearwright {

/// The part of a flank at which the teeth touch. A ridge is the line at which a linear relief
/// starts, so that the slope of the flank jumps there.
enum class TouchKind {
  none,
  interior,
  line,
  tip1,
  tip2,
  face1,
  face2,
  form1,
  form2,
  ridge,
  corner
};
std::string_view to_string(TouchKind kind);
/// True for the edges of a tooth, where no contact should occur. The line at which a relief starts
/// is not an edge.
bool is_edge(TouchKind kind);
/// True for edges and for ridges, where the slope of the surface jumps. A touch of this kind has no
/// contact ellipse, and a computed pressure is only a lower bound of the actual pressure.
bool is_sharp(TouchKind kind);

/// If the gap along a line stays below this value, mm, the line counts as a contact line. Real
/// flanks have greater deviations.
inline constexpr double kLineGap = 1e-6;

struct ContactEllipse {
  std::optional<double> semi_major;  ///< √(2δ/k1)  mm; none if k1 ≤ 0
  double semi_minor;                 ///< √(2δ/k2)  mm
  /// Angle of the major axis about the normal, in (−π/2, π/2]. It is 0 along the projection of axis
  /// 1 onto the tangent plane.
  Angle angle;
};

/// A touch on a ridge of a flank. The gap opens with a slope towards both sides of the ridge.
struct ContactRidge {
  int gear;      ///< 1 or 2, the gear whose flank has the ridge
  double along;  ///< curvature of the gap along the ridge, 1/mm, which is equal on both sides
  struct Side {
    double slope;                     ///< ≥ 0, slope of the gap away from the ridge
    std::array<double, 2> curvature;  ///< principal curvatures of the gap on this side, 1/mm
  };
  std::array<Side, 2> side;  ///< the first is the side of smaller diameter or height
  bool by_height = false;    ///< true if the two sides differ by height, false if by diameter
};

/// Converts angles of gear 2 to lengths if gear 2 is a rack. Results store the travel of a rack as
/// the angle travel/r. The pinion rolls along the rack by this angle.
struct RackTravel {
  double radius = 0.0;  ///< reference radius r of the pinion, mm; 0 if gear 2 is not a rack
  explicit operator bool() const { return radius > 0.0; }
  double of(Angle angle) const { return radius * angle.rad(); }  ///< mm
};

struct ContactPoint {
  Angle rotation1, rotation2;
  Angle te;      ///< > 0 if gear 2 is ahead
  int pair = 0;  ///< k, number of the tooth pair that touches
  TouchKind kind = TouchKind::none;
  Vec3 point = Vec3::Zero();   ///< mm, housing
  Vec3 normal = Vec3::Zero();  ///< points out of gear 1, in the housing
  /// 2ρ and z in the frame of each gear, mm; for a rack, the height above its datum line instead
  /// of 2ρ
  std::array<double, 2> diameter{}, height{};
  RackTravel rack{};
  std::optional<Angle> rack_angle;  ///< normal angle of the rack that cut gear 1, at the touch
  /// k1, k2  1/mm, for the kind line, and for the kind interior unless a bound of the patch is
  /// active.
  std::optional<std::array<double, 2>> gap_curvature;
  std::optional<ContactEllipse> ellipse;  ///< none without gap_curvature, or if k2 ≤ 0
  std::optional<ContactRidge> ridge;
  std::optional<std::array<Vec3, 2>> line;  ///< ends of a contact line, housing
};

/// True if a touch lies at a seam and T rises beyond it. Such a touch is not a point of contact.
bool at_seam(Transmission& transmission, const PairTouch& touch);

/// True if an edge of a tooth touches. This test is faster than describe() followed by is_edge().
bool on_edge(Transmission& transmission, const PairTouch& touch);

/// Describes a touch.
///
/// Units     mm; `rotation1` is the rotation in the housing
/// Accuracy  curvatures are exact at the computed point; ledger rows `contact.*`
ContactPoint describe(Transmission& transmission, const PairTouch& touch, Angle rotation1,
                      double marking);

namespace detail {
/// The gap around a touch on a ridge, to the first order in the slopes. [T8.25]
///
/// Domain    a touch whose active bound is a ridge (contract)
ContactRidge ridge_at(Transmission& transmission, const PairTouch& touch);
}  // namespace detail

}  // namespace gearwright
