// The input of a double-helical gear: two halves of opposite hands on one body.
//
//   b      whole face with the gap, mm     b_B  face of one half, (b − gap)/2, mm
//                                              theory: docs/theory/02-involute-and-pair.md, 2.11
#pragma once

#include <array>
#include <optional>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/error.hpp"

namespace gearwright {

/// As a drawing gives it. The face width of the gear includes both halves and the gap.
struct DoubleHelical {
  double gap = 0.0;                         ///< mm, between the halves
  double stagger_pitches = 0.0;             ///< s, of the half at z < 0 relative to the other one
  std::optional<double> groove_diameter{};  ///< mm, of the gear within the gap
  std::optional<double> hob_diameter{};     ///< d_a0  mm; if absent, the run-out is not computed
  Angle hob_lead_angle{};                   ///< γ_0
  double hob_half_length = 0.0;             ///< l_0   mm
};

/// Ends the message for an absent face width.
inline constexpr const char* kWholeFace =
    "; for a double-helical gear it includes both halves and the gap";

/// The error of a gap that leaves no half.
///
/// Units     `face` mm, the whole face width
/// Errors    `double_helical.gap`
std::optional<Error> half_error(const DoubleHelical& given, double face);

/// The errors of two gears that mesh: the halves must have equal faces up to the width of the
/// narrower one.
///
/// Units     `faces` mm, the whole face widths
/// Domain    one of the gears is double-helical (contract)
/// Errors    `gearN.double_helical` that is absent while the mating gear has one,
///           `gear2.double_helical.stagger_pitches` that differ,
///           `gear2.double_helical.gap` if the halves are not opposite each other
std::optional<Error> mates_error(const std::array<std::optional<DoubleHelical>, 2>& halves,
                                 const std::array<double, 2>& faces);

}  // namespace gearwright
