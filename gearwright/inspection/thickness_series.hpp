// Named allowances and tolerances: tooth thickness by DIN 3967, centre distances, tips, bores and
// keyways by ISO 286 and DIN 6885.
//
//   E_sns, T_sn   upper allowance and tolerance of the normal tooth thickness, µm
//   JS7           ± half of the tolerance grade IT7
//   H7            from 0 to IT7; N9 from −IT9 to 0; P9 lies below by the fundamental deviation
//                                              theory: docs/theory/10-inspection.md
#pragma once

#include <array>
#include <string_view>

#include "gearwright/base/result.hpp"

namespace gearwright {

/// E_sni and E_sns, mm, of "cd25" on a gear of that reference diameter. [T10.20]
///
/// Errors    `series`: no such name; the table ends at a reference diameter of 10 000 mm
Result<std::array<double, 2>> thickness_allowances(std::string_view series,
                                                   double reference_diameter);

/// Half of the tolerance grade, mm, which is the ± deviation of JS. [T10.21]
///
/// Errors    `tolerance`: not JS1 to JS12; `center_distance`: the table ends at 3150 mm
Result<double> js_deviation(std::string_view tolerance, double center_distance);

/// Deviations of a hole or a keyway from its nominal size, lower and upper, mm.
///
/// Source    ISO 286-1, tables 1 and 3; ISO 286-2
/// Errors    `fit`: not H1 to H12, JS1 to JS12, N9 or P9; `size`: the table ends at 3150 mm, and of N9
///           and P9 at 120 mm
Result<std::array<double, 2>> hole_deviations(std::string_view fit, double size);

/// Deviations of the tip diameter, lower and upper, mm. The tip of an external gear is a shaft, with
/// the deviations of the hole of the same name in the opposite direction; that of an internal gear is
/// a hole.
///
/// Errors    `fit`: not h1 to h12 or js1 to js12, for an internal gear H1 to H12 or JS1 to JS12;
///           `size`: the table ends at 3150 mm
Result<std::array<double, 2>> tip_deviations(std::string_view fit, double size, bool internal);

/// Upper deviation of the depth of a keyway in a hub, mm; the lower one is 0.
///
/// Source    DIN 6885-1
/// Units     `width` of the keyway in mm
double keyway_depth_deviation(double width);

}  // namespace gearwright
