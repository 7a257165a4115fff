// The input of a double-helical gear, which has two halves of opposite hands on one body.
//
//   b      whole face width, including the gap, mm     b_B  face width of one half, (b − gap)/2, mm
//                                              theory: docs/theory/02-involute-and-pair.md, 2.11
#pragma once

#include <array>
#include <optional>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/error.hpp"

namespace gearwright {

/// The values on the drawing. The face width of the gear includes both halves and the gap.
struct DoubleHelical {
  double gap = 0.0;              ///< mm, between the halves
  double stagger_pitches = 0.0;  ///< s  pitches, offset of the half at z < 0 from the half at z > 0
  std::optional<double> groove_diameter{};  ///< mm, diameter of the gap's groove
  std::optional<double> hob_diameter{};     ///< d_a0  mm; if absent, the run-out is not computed
  Angle hob_lead_angle{};                   ///< γ_0   lead angle of the hob
  double hob_half_length = 0.0;             ///< l_0   mm, half the cutting length of the hob
};

/// End of the message for an absent face width.
inline constexpr const char* kWholeFace =
    "; for a double-helical gear, the face width includes both halves and the gap";
/// Returns the error if the gap leaves no face width for the halves. `face` is the whole face
/// width, mm.
///
/// Errors    `double_helical.gap`
std::optional<Error> half_error(const DoubleHelical& given, double face);
/// Returns the error if two mating gears do not match. Each half of the gear with the narrower
/// halves must lie within the opposite half of the other gear. `faces` are the whole face widths,
/// mm.
///
/// Domain    at least one gear is double-helical (contract)
/// Errors    `gearN.double_helical` if only the mating gear is double-helical,
///           `gear2.double_helical.stagger_pitches` if the staggers differ,
///           `gear2.double_helical.gap` if the halves are not opposite each other
std::optional<Error> mates_error(const std::array<std::optional<DoubleHelical>, 2>& halves,
                                 const std::array<double, 2>& faces);

}  // namespace gearwright
