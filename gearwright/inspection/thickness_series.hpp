// Named allowances and tolerances: tooth thickness by DIN 3967, centre distance by ISO 286.
//
//   E_sns, T_sn   upper allowance and tolerance of the normal tooth thickness, µm
//   JS7           ± half of the tolerance grade IT7
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

}  // namespace gearwright
