// Exact derivatives of the transmission error and of the contact point with respect to an error or
// to the amount of a modification.
//
//   e          an error, or an amount of a modification     T, φ2*   as in gap_field.hpp
//   c_j, μ_j   active bounds of the touch and their multipliers (touch.hpp)
//   H          Hessian of T with respect to s and z     N   frame of contact_pair.hpp
//   p = ∂φ2*/∂e at a fixed point of flank 1, with its derivatives with respect to s and z
//   ∂TE/∂e  = p + Σ μ_j ∂c_j/∂e      over the active bounds of flank 2, which move with e
//   ∂(s,z)/∂e = −H⁻¹ ∇p              inside the flanks; otherwise along the active bounds
//                                    theory: docs/theory/08-contact.md, [T8.10]
#pragma once

#include <array>

#include "gearwright/contact/transmission.hpp"

namespace gearwright {

/// An error of mounting or of the lead, with the unit to which a derivative refers.
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

/// The variable of a derivative: an error, or an amount (mm) of a modification of gear 1 or 2.
struct Influence {
  ErrorKind error = ErrorKind::center_distance;
  int modified_gear = 0;  ///< 0 selects `error`; 1 or 2 selects `modification` of that gear
  Modification modification = Modification::tip_relief;
};

struct Sensitivity {
  double te;   ///< ∂TE/∂e   rad per unit of e; TE has the sign of a rotation in the housing
  Vec3 point;  ///< ∂r/∂e    mm per unit of e, in the housing
};

/// Returns the derivatives of TE and of the contact point at a touch.
///
/// Units     rad or mm, per mm or per rad of the influence
/// Domain    a touch with contact; a modified gear has a RemovalField (contract)
/// Accuracy  `te` to rounding; `point` as accurate as the contact point. For a line contact,
///           `point` has no meaning
Sensitivity sensitivity(Transmission& transmission, const PairTouch& touch,
                        const Influence& influence);

/// Returns ∂T*/∂e in the frame N, rad per unit of e. T* is the greatest T over the profile at a
/// fixed height z of flank 1, and lies at the parameter s. If the point (s, z) lies opposite an end
/// of the patch of flank 2, s changes with e so that the point stays opposite this end.
///
/// Domain    as sensitivity(), for patches of this pair (contract)
/// Accuracy  rounding
double row_slope(const ContactPair& pair, const GapField& field, double s, double z,
                 const Influence& influence);

/// The effect on T, in the frame N, of removing material from a flank. [T8.7]
struct RemovalTurn {
  double te;                    ///< change of T*, rad per mm removed
  double u, z;                  ///< the point, as arguments of the gear's RemovalField
  RemovalField::Piece piece{};  ///< piece of the patch; empty without a field
};

/// Returns the effect on T* of removing material from `gear`. T* is the greatest T over the profile
/// at a fixed height z of flank 1, and lies at the parameter s.
///
/// Units     rad, mm
/// Domain    gear 1 or 2; patches of this pair (contract)
/// Accuracy  rounding
/// Laws      `te` times the removal per unit of a modification is row_slope() of this modification
RemovalTurn row_turn(const ContactPair& pair, const GapField& field, double s, double z, int gear);

/// Returns dTE/dφ1, rad/rad, exact, by the method of sensitivity(); e is the rotation of gear 1.
double rotation_slope(Transmission& transmission, const PairTouch& touch);

}  // namespace gearwright
