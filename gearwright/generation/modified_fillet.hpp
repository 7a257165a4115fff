// Fillets that no rack cuts: circular arcs at the root and at the tip of an involute tooth.
//
//   ξ_C, ξ_J   roll angles of the flank's points at which root and tip fillet begin
//   δ = ψ_b − ξ     the direction of the flank at ξ; its normal touches the base circle at polar δ
//   η = π/z − ψ_b   half the space on the base circle, u = ξ_C + η
//                                              theory: docs/theory/06-few-teeth.md
//
// Both arcs are tangent to the flank, so that their centres lie on its normal: the root fillet's
// where that meets the space's centre line, the tip fillet's where it meets the tooth's. Both are
// closed forms of the roll angle, and no sine law is needed.
#pragma once

#include <optional>

#include "gearwright/curve/basic_curves.hpp"

namespace gearwright {

/// A fillet arc: its circle by the distance of the centre from the axis, and how far it spans.
struct FilletArc {
  double radius;    ///< r_r or r_t  mm
  double distance;  ///< of the centre from the gear's axis, mm
  double span;      ///< σ  rad, from the flank to the centre line
  double end;       ///< mm: radius at which the arc meets the centre line
};

/// The root fillet that touches the flank at ξ_C and is centred in the space; nothing when the
/// flank's normal does not meet the space's centre line outside the tooth.
///
/// Formula   r_r = r_b (tan u − ξ), D = r_b/cos u, σ = π/2 − u, end D − r_r; [T6.2]
/// Domain    ξ_C ≥ 0, teeth ≥ 1 (contract)
std::optional<FilletArc> root_fillet_at(const Involute& flank, int teeth, double xi);

/// The tip fillet that touches the flank at ξ_J and is centred in the tooth; nothing beyond the
/// pointed tooth.
///
/// Formula   r_t = r_b (ξ + tan δ), D = r_b/cos δ, σ = π/2 + δ, end D + r_t; [T6.3]
/// Domain    ξ_J ≥ 0 (contract)
std::optional<FilletArc> tip_fillet_at(const Involute& flank, double xi);

/// The ξ_J of a given r_t: dr_t/dξ = −r_b tan² δ, so there is one. Nothing: r_t is greater than
/// the whole flank allows. [T6.4]
///
/// Domain    r_t > 0 (contract)
std::optional<double> roll_of_tip_fillet(const Involute& flank, double radius);

}  // namespace gearwright
