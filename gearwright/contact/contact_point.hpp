// Describes a touch for the user: its position on both gears and in the housing, its kind, and how
// closely the flanks conform there.
//
//   k1 ≤ k2   curvatures of the gap, 1/mm: principal values of K2 − K1
//   δ         thickness of the marking compound, mm
//                                    theory: docs/theory/08-contact.md, [T8.15]…[T8.17]
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "gearwright/contact/transmission.hpp"

namespace gearwright {

/// ridge: start of a linear relief, an edge due to a modification
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
/// True for edges of a tooth, which should not touch. The start of a relief is not an edge.
bool is_edge(TouchKind kind);
/// True for edges and for the start of a relief. The surface bends sharply there, so there is no
/// ellipse and a pressure is a lower bound.
bool is_sharp(TouchKind kind);

/// A flat ridge with a smaller gap counts as a contact line, mm. No flank is smoother.
inline constexpr double kLineGap = 1e-6;

struct ContactEllipse {
  std::optional<double> semi_major;  ///< √(2δ/k1)  mm; none if the gap is flat in that direction
  double semi_minor;                 ///< √(2δ/k2)  mm
  Angle angle;  ///< in (−π/2, π/2]: projection of axis 1 to the major axis, about the normal
};

/// A touch on the ridge of a flank, at which the flank has an angle. The gap opens with a slope
/// towards both sides.
struct ContactRidge {
  int gear;      ///< 1 or 2, the gear whose flank has the ridge
  double along;  ///< 1/mm: curvature of the gap along the ridge, equal on both sides
  struct Side {
    double slope;                     ///< ≥ 0, slope of the gap away from the ridge
    std::array<double, 2> curvature;  ///< 1/mm: principal values of the gap of that side's flank
  };
  std::array<Side, 2> side;  ///< first the side of the lesser diameter or height
  bool by_height = false;    ///< true for an end relief, whose sides differ by their height
};

struct ContactPoint {
  Angle rotation1, rotation2;
  Angle te;      ///< > 0 if gear 2 is ahead
  int pair = 0;  ///< k
  TouchKind kind = TouchKind::none;
  Vec3 point = Vec3::Zero();                   ///< mm, housing
  Vec3 normal = Vec3::Zero();                  ///< out of gear 1, in the housing
  std::array<double, 2> diameter{}, height{};  ///< mm on each gear: 2ρ, and z of its own frame
  std::optional<Angle> rack_angle;             ///< normal angle of the rack that cut gear 1
  std::optional<std::array<double, 2>> gap_curvature;  ///< 1/mm; interior and line
  std::optional<ContactEllipse> ellipse;
  std::optional<ContactRidge> ridge;
  std::optional<std::array<Vec3, 2>> line;  ///< ends of a contact line, housing
};

/// True if a seam of patches bounds a touch while T rises beyond the seam. It is then no place of
/// contact of its own.
bool at_seam(Transmission& transmission, const PairTouch& touch);

/// True if an edge of a tooth touches: is_edge() of the kind that describe() returns, computed with
/// less work.
bool on_edge(Transmission& transmission, const PairTouch& touch);

/// Everything about a touch of pair 0 at `touch.phi`.
///
/// Units     mm; `rotation1` in the housing's sense
/// Accuracy  curvatures are exact at the point that was found, see ledger rows `contact.*`
ContactPoint describe(Transmission& transmission, const PairTouch& touch, Angle rotation1,
                      double marking);

}  // namespace gearwright
