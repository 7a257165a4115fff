// Positions on a flank for measuring machines: roll lengths, and the evaluation ranges of
// tolerances.
//
//   L_y, ξ_y   roll length, mm, and roll angle, rad, of the involute at d_y
//   L_α, L_β   evaluation ranges of profile and helix, mm
//   d_Nf, d_Na active root and tip diameter, mm: where contact with the mating gear ends
//                                              theory: docs/theory/10-inspection.md
#pragma once

#include <array>
#include <optional>

#include "gearwright/gear/gear.hpp"
#include "gearwright/inspection/usable_flank.hpp"

namespace gearwright {

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
  RollPlace root_form, reference, tip_form;  ///< at d_Ff, d, d_Fa
  std::array<double, 2> profile;             ///< mm, roll lengths from … to
  std::array<double, 2> helix;               ///< mm, heights from the middle of the face
  std::optional<ActiveFlank> active{};       ///< of a mounted gear that touches the other
};

/// Formula   [T10.22]
/// Domain    d_y ≥ d_b (contract)
RollPlace roll_place(const Gear& gear, double diameter);

/// ISO 1328-1: the usable profile without a twentieth at the tip, and the face without a twentieth,
/// or a module if that is less, at each end. [T10.23]
///
/// None      no usable flank
std::optional<EvaluationRanges> evaluation_ranges(const Gear& gear);

/// The ends of the path of contact as clipped: to both usable flanks, and on crossed axes to the
/// faces. `which`: 1 or 2.
///
/// Formula   L_N1 = ρ_1, L_N2 = ρ_2 at the two ends; [T10.28]
/// None      the gears do not touch
std::optional<ActiveFlank> active_flank(const InvolutePair& pair, int which);

}  // namespace gearwright
