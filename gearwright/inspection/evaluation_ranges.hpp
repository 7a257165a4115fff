// Where a measuring machine looks at a flank: roll lengths, and the ranges that tolerances hold for.
//
//   L_y, ξ_y   roll length, mm, and roll angle, rad, of the involute at d_y
//   L_α, L_β   evaluation ranges of profile and helix, mm
//                                              theory: docs/theory/10-inspection.md
#pragma once

#include <array>
#include <optional>

#include "gearwright/gear/gear.hpp"
#include "gearwright/inspection/usable_flank.hpp"

namespace gearwright {

struct RollPlace {
  double diameter;  ///< d_y  mm
  double length;    ///< L_y  mm
  double angle;     ///< ξ_y  rad
};

struct EvaluationRanges {
  RollPlace root_form, reference, tip_form;  ///< at d_Ff, d, d_Fa
  std::array<double, 2> profile;             ///< mm, roll lengths from … to
  std::array<double, 2> helix;               ///< mm, heights from the middle of the face
};

/// Formula   [T10.22]
/// Domain    d_y ≥ d_b (contract)
RollPlace roll_place(const Gear& gear, double diameter);

/// ISO 1328-1: the usable profile but for its twentieth at the tip, the face but for its twentieth,
/// or a module if that is less, at either end. [T10.23]
///
/// None      no usable flank
std::optional<EvaluationRanges> evaluation_ranges(const Gear& gear);

}  // namespace gearwright
