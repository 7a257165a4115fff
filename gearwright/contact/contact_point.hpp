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

enum class TouchKind { none, interior, line, tip1, tip2, face1, face2, form1, form2, corner };
std::string_view to_string(TouchKind kind);
/// Edges, which touch where the flanks themselves should.
bool is_edge(TouchKind kind);

/// Gap below which a flat ridge counts as a contact line, mm: less than any flank is smooth.
inline constexpr double kLineGap = 1e-6;

struct ContactEllipse {
  std::optional<double> semi_major;  ///< √(2δ/k1)  mm; none where the gap is flat that way
  double semi_minor;                 ///< √(2δ/k2)  mm
  Angle angle;  ///< in (−π/2, π/2]: projection of axis 1 to the major axis, about the normal
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
  std::optional<std::array<Vec3, 2>> line;  ///< ends of a contact line, housing
};

/// Everything about a touch of pair 0 at `touch.phi`.
///
/// Units     mm; `rotation1` in the housing's sense
/// Accuracy  curvatures are exact at the point found: ledger rows `contact.*`
ContactPoint describe(Transmission& transmission, const PairTouch& touch, Angle rotation1,
                      double marking);

}  // namespace gearwright
