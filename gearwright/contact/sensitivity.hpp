// Exact derivatives of transmission error and contact point by every error and every modification.
//
//   e          an error or a chosen number
//   p = ∂φ2*/∂e at a fixed place of flank 1, with its derivatives over the flank
//   ∂TE/∂e  = p + Σ μ_j ∂c_j/∂e      over active bounds c_j of flank 2, which move with e
//   ∂(s,z)  = −H⁻¹ ∇p                inside; along the active bounds otherwise
//                                    theory: docs/theory/08-contact.md, [T8.10]
#pragma once

#include <array>

#include "gearwright/contact/transmission.hpp"

namespace gearwright {

enum class ErrorKind {
  center_distance,  ///< per mm
  crossing,         ///< per rad
  intersecting,     ///< per rad
  axial,            ///< per mm
  helix_slope1,     ///< per mm of f_Hβ
  helix_slope2
};
constexpr std::array<ErrorKind, 6> kErrorKinds{ErrorKind::center_distance, ErrorKind::crossing,
                                               ErrorKind::intersecting,    ErrorKind::axial,
                                               ErrorKind::helix_slope1,    ErrorKind::helix_slope2};

/// An error, or an amount of a modification of gear 1 or 2 (per mm removed).
struct Influence {
  ErrorKind error = ErrorKind::center_distance;
  int modified_gear = 0;  ///< 1, 2: `modification` of that gear instead of `error`
  RemovalField::Parameter modification = RemovalField::Parameter::tip_relief;
};

struct Sensitivity {
  double te;   ///< ∂TE/∂e   rad per unit, in the housing's sense of rotation
  Vec3 point;  ///< ∂r/∂e    mm per unit, in the housing
};

/// Units     rad, mm; per mm or rad of the influence
/// Domain    a touch that was found; a modification of a gear that has a RemovalField (contract)
/// Accuracy  TE: rounding; point: as the contact point itself, and meaningless along a line contact
Sensitivity sensitivity(Transmission& transmission, const PairTouch& touch,
                        const Influence& influence);

/// ∂T*/∂e of the greatest T over the profile at a fixed height z of flank 1, which lies at s: rad in
/// N per unit. A place at the end of a patch of flank 2 moves along flank 1 with that end.
///
/// Domain    as sensitivity(), for patches of this pair (contract)
/// Accuracy  rounding
double row_slope(const ContactPair& pair, const GapField& field, double s, double z,
                 const Influence& influence);

/// dTE/dφ1, rad/rad: exact, by the same rule with the rotation of gear 1 in place of an error.
double rotation_slope(Transmission& transmission, const PairTouch& touch);

}  // namespace gearwright
