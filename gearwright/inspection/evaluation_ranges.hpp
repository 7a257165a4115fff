// Computes roll lengths and evaluation ranges of a flank for measuring machines.
//
//   L_y, ξ_y   roll length, mm, and roll angle, rad, of the involute at d_y
//   L_α, L_β   evaluation ranges of profile and helix, mm
//   d_Nf, d_Na active root and tip diameter, mm, at which contact with the mating gear ends
//                                              theory: docs/theory/10-inspection.md
#pragma once

#include <array>
#include <optional>

#include "gearwright/gear/gear.hpp"

namespace gearwright {

// The usable flank between d_Ff and d_Fa, on which a measuring tool can touch.
//
//   d_Ff, d_Fa   form diameters, mm       d_y   diameter of a contact, mm
//   d_V          diameter of the V circle, mm, at which tools of the usual size touch
//
// The flank of an internal gear extends outward from d_Fa, because the tip lies inside.

enum class ContactPlace {
  usable,           ///< on the involute, between d_Ff and d_Fa
  below_flank,      ///< at the root fillet, which is not an involute; the reading has no meaning
  on_tip_rounding,  ///< between d_Fa and the tip, on a chamfer or a rounding
  beyond_tip        ///< beyond the tip of the tooth
};
struct UsableFlank {
  double root_end;  ///< d_Ff  mm; the root diameter for an internal gear without a tooth
  double tip_end;   ///< d_Fa  mm
  double tip;       ///< mm, diameter at which the tooth ends
  double side;      ///< σ of the gear

  double least() const { return side > 0.0 ? root_end : tip_end; }
  double greatest() const { return side > 0.0 ? tip_end : root_end; }
  double middle() const { return (root_end + tip_end) / 2; }
  bool contains(double diameter) const { return diameter >= least() && diameter <= greatest(); }
  ContactPlace place(double diameter) const;
};

/// Returns the usable flank of a gear, or none if no flank is left or the teeth are not involutes.
std::optional<UsableFlank> usable_flank(const Gear& gear);
/// Returns the usable flank, for a measuring tool whose input `field` has the value `value`.
///
/// Errors    `field` if the teeth are not involutes or no flank is left
Result<UsableFlank> measurable_flank(const Gear& gear, const char* field, double value);
/// True if plane anvils and straight pins fit into the tooth spaces. They do not fit into the
/// spaces of an internal helical gear.
bool straight_tools_fit(const Gear& gear);
/// Returns the diameter d_V of the V circle.
///
/// Formula   d_V = d ± 2 x m_n, with d > 0 and with minus for an internal gear; [T10.1]
double v_circle_diameter(const Gear& gear);
/// Returns the contact diameter of tools of the usual size. It is d_V, or the middle of the usable
/// flank if d_V lies outside this flank.
double usual_contact_diameter(const Gear& gear, const UsableFlank& flank);

struct InvolutePair;  // pair/involute_pair.hpp

struct RollPlace {
  double diameter;  ///< d_y  mm
  double length;    ///< L_y  mm
  double angle;     ///< ξ_y  rad
};

/// The part of the flank that the mating gear touches.
struct ActiveFlank {
  RollPlace root, tip;  ///< at d_Nf, d_Na
};

struct EvaluationRanges {
  RollPlace root_form, reference, tip_form;  ///< at d_Ff, d (d_b if this is greater), d_Fa
  std::array<double, 2> profile;             ///< mm, roll lengths of both ends
  std::array<double, 2> helix;          ///< mm, heights of both ends from the middle of the face
  std::optional<ActiveFlank> active{};  ///< present if the gear is mounted and touches its mating
                                        ///< gear
};
/// Returns the roll length and the roll angle of the involute at the diameter d_y.
///
/// Formula   [T10.22]
/// Domain    d_y ≥ d_b (contract)
RollPlace roll_place(const Gear& gear, double diameter);
/// Returns the evaluation ranges of ISO 1328-1. The range of the profile is the usable profile
/// without 5 % of its length at the tip. The range of the helix is the face without 5 % of its
/// width at each end, or without one module at each end if that is less. [T10.23]
///
/// None      if there is no usable flank
std::optional<EvaluationRanges> evaluation_ranges(const Gear& gear);
/// Returns the ends of contact on the flank of gear `which` (1 or 2). The path of contact is
/// clipped to both usable flanks and, on crossed axes, to the faces.
///
/// Formula   L_N1 = ρ_1, L_N2 = ρ_2 at the two ends; [T10.28]
/// None      if the gears do not touch
std::optional<ActiveFlank> active_flank(const InvolutePair& pair, int which);

}  // namespace gearwright
