// What a touch is for a person: where it lies on both gears and in the housing, of which kind, and
// how closely the flanks hug each other there.
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

/// ridge: where a linear relief begins, an edge that a modification has made
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
/// Edges of a tooth, which touch where the flanks themselves should. The start of a relief is none.
bool is_edge(TouchKind kind);
/// Edges and the start of a relief: the surface bends sharply there, so that no ellipse is left and
/// a pressure is a lower bound.
bool is_sharp(TouchKind kind);

/// Gap below which a flat ridge counts as a contact line, mm: less than any flank is smooth.
inline constexpr double kLineGap = 1e-6;

struct ContactEllipse {
  std::optional<double> semi_major;  ///< √(2δ/k1)  mm; none where the gap is flat that way
  double semi_minor;                 ///< √(2δ/k2)  mm
  Angle angle;  ///< in (−π/2, π/2]: projection of axis 1 to the major axis, about the normal
};

/// A touch on the ridge of a flank, which bends by an angle there: seen from either side the gap
/// opens with a slope.
struct ContactRidge {
  int gear;      ///< 1 or 2, whose flank has it
  double along;  ///< 1/mm: curvature of the gap along the ridge, the same from either side
  struct Side {
    double slope;                     ///< ≥ 0: of the gap, away from the ridge
    std::array<double, 2> curvature;  ///< 1/mm: principal values of the gap of that side's flank
  };
  std::array<Side, 2> side;  ///< that of the lesser diameter, or height, first
};

struct ContactPoint {
  Angle rotation1, rotation2;
  Angle te;      ///< > 0: gear 2 is ahead
  int pair = 0;  ///< k
  TouchKind kind = TouchKind::none;
  Vec3 point = Vec3::Zero();                   ///< mm, housing
  Vec3 normal = Vec3::Zero();                  ///< out of gear 1, housing
  std::array<double, 2> diameter{}, height{};  ///< mm on each gear: 2ρ, and z of its own frame
  std::optional<Angle> rack_angle;             ///< of the rack that cut gear 1
  std::optional<std::array<double, 2>> gap_curvature;  ///< 1/mm; interior and line
  std::optional<ContactEllipse> ellipse;
  std::optional<ContactRidge> ridge;
  std::optional<std::array<Vec3, 2>> line;  ///< ends of a contact line, housing
};

/// Whether a touch is held at a seam of patches, beyond which T rises: no place of its own.
bool at_seam(Transmission& transmission, const PairTouch& touch);

/// Whether an edge of a tooth touches: is_edge() of the kind that describe() gives, for less work.
bool on_edge(Transmission& transmission, const PairTouch& touch);

/// Everything about a touch of pair 0 at `touch.phi`.
///
/// Units     mm; `rotation1` in the housing's sense
/// Accuracy  curvatures are exact at the point found: ledger rows `contact.*`
ContactPoint describe(Transmission& transmission, const PairTouch& touch, Angle rotation1,
                      double marking);

}  // namespace gearwright
