// Computes circular fillets at the root and at the tip of an involute tooth from the dimensions on
// a drawing. The functions of generate.hpp add them to the tooth in place of the fillets that the
// rack cuts.
//
//   l    position along the straight flank of the rack in the normal section, mm, measured from the
//        lower end of the flank; the height x of the rack and the roll angle ξ are linear in l
//   F    limit of undercut, ξ = 0          C, J    points where root and tip fillet touch the flank
//   δ = ψ_b − ξ     polar angle at which the normal of the flank at ξ touches the base circle
//   η = π/z − ψ_b   half angle of the space on the base circle, u = ξ_C + η
//   γ    polar angle of the centre of a rounded tip corner, and half angle of the remaining land
//                                              theory: docs/theory/06-few-teeth.md
//
// All arcs are tangent to the flank, so the centre of each arc lies on a normal of the flank. The
// centre of the root fillet also lies on the centre line of the space. The centre of the tip fillet
// also lies on the centre line of the tooth. The centre of a rounded tip corner lies one radius of
// the corner inside the tip circle.
#pragma once

#include <optional>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/result.hpp"
#include "gearwright/curve/basic_curves.hpp"
#include "gearwright/generation/rack_envelope.hpp"
#include "gearwright/tool/cutter_edge.hpp"

namespace gearwright {

/// The circular root fillet that [gearN.root_fillet] of a spec requests.
struct RootFilletSpec {
  double offset = 0.0;  ///< mm, l_C = max(l_F, 0) + offset
};

/// The circular tip fillet that [gearN.tip_fillet] of a spec requests. One of its dimensions is
/// given.
struct TipFilletSpec {
  enum class By {
    radius,      ///< r_t
    l,           ///< l_J, position of the point J on the flank
    end_radius,  ///< end of the finished tip on the centre line of the tooth
    corner       ///< ρ_a of each tip corner; a land is left between the two corners
  };
  By by = By::radius;
  double value = 0.0;  ///< mm
};

/// The roll angle ξ as a linear function of the position l on the straight flank of the rack.
/// [T6.5]
struct FlankRuler {
  Involute flank;
  double roll_at_0;    ///< ξ at l = 0
  double roll_per_mm;  ///< dξ/dl
  double end;          ///< l of the flank's upper end, mm, or infinite

  double roll(double l) const { return roll_at_0 + roll_per_mm * l; }
  double l(double roll) const { return (roll - roll_at_0) / roll_per_mm; }
  double undercut_l() const { return l(0.0); }  ///< l_F, signed: < 0 without undercut
};

FlankRuler flank_ruler(const CutterEdge& edge, const RackMotion& motion);

struct FilletArc {
  double radius;    ///< r_r or r_t  mm
  double distance;  ///< D  distance of the centre from the gear axis, mm
  Angle span;       ///< σ  angle of the arc from the flank to the centre line or to the land
  double end;       ///< mm: radius at which the arc meets the centre line or the land
  Angle land{};     ///< γ  half angle of the land; 0 if there is none
};

/// Returns the root fillet that touches the flank at ξ_C and is centred in the space. The result is
/// empty if no such circle lies in the space, because the normal of the flank does not meet the
/// centre line of the space there.
///
/// Formula   r_r = r_b (tan u − ξ), D = r_b/cos u, σ = π/2 − u, end D − r_r; [T6.2]
/// Domain    ξ_C ≥ 0, teeth ≥ 1 (contract)
std::optional<FilletArc> root_fillet_at(const Involute& flank, int teeth, double xi);

/// Returns the tip fillet that touches the flank at ξ_J and is centred in the tooth. The result is
/// empty if ξ_J lies beyond the point at which both flanks of the tooth meet, or if |δ| ≥ π/2,
/// because the normal of the flank then does not meet the centre line.
///
/// Formula   r_t = r_b (ξ + tan δ), D = r_b/cos δ, σ = π/2 + δ, end D + r_t; [T6.3]
/// Domain    ξ_J ≥ 0 (contract)
std::optional<FilletArc> tip_fillet_at(const Involute& flank, double xi);

/// Returns ξ_J for a given r_t. The result is unique, because dr_t/dξ = −r_b tan² δ. It is empty if
/// r_t is too large for every point of the flank. [T6.4]
///
/// Domain    r_t > 0 (contract)
std::optional<double> roll_of_tip_fillet(const Involute& flank, double radius);

struct CircularFillet {
  double roll;  ///< ξ_C or ξ_J  rad
  FilletArc arc;
};

/// Returns the rounding of a tip corner, tangent to the flank and to the tip circle.
///
/// Formula   r_b ξ_J = ρ_a + √((r_a − ρ_a)² − r_b²), D = r_a − ρ_a, γ = δ + acos(r_b/D),
///           σ = π/2 − acos(r_b/D); [T6.17]
/// Domain    0 < ρ_a ≤ r_a − r_b; `tip_radius` is r_a, `radius` is ρ_a (contract)
CircularFillet tip_corner_at(const Involute& flank, double tip_radius, double radius);

struct CircularFillets {
  std::optional<CircularFillet> root, tip;
};

/// Computes the requested fillets. `tip_radius` is the radius of the blank, if given. For the
/// rounding of a tip corner, it is the radius at which the tooth ends.
///
/// Errors    `root_fillet.offset`, `tip_fillet.radius`, `tip_fillet.l`, `tip_fillet.end_radius` or
///           `tip_fillet.corner_radius` with the range that fits; `tip_fillet` if no flank is left
/// Domain    `tip_radius` is given for the rounding of a tip corner (contract)
Result<CircularFillets> circular_fillets(const FlankRuler& ruler, int teeth,
                                         const std::optional<RootFilletSpec>& root,
                                         const std::optional<TipFilletSpec>& tip,
                                         std::optional<double> tip_radius);

}  // namespace gearwright
