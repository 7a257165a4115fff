// Provides allowances and tolerances that are given by the name of a series or of a grade. The
// series of DIN 3967 apply to the tooth thickness. ISO 286 and DIN 6885 apply to centre distances,
// tips, bores and keyways.
//
//   E_sns, T_sn   upper allowance and tolerance of the normal tooth thickness, µm
//   JS7           from −IT7/2 to IT7/2
//   H7            from 0 to IT7
//   N9            from −IT9 to 0, both lower by 4 µm for sizes up to 3 mm
//   P9            from −IT9 to 0, both lower by the fundamental deviation of P
//                                              theory: docs/theory/10-inspection.md
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "gearwright/base/result.hpp"

namespace gearwright {

/// Returns E_sni and E_sns, mm, of a series such as "cd25" for this reference diameter. [T10.20]
///
/// Errors    `series` if there is no such series, or if the reference diameter exceeds 10 000 mm
Result<std::array<double, 2>> thickness_allowances(std::string_view series,
                                                   double reference_diameter);
/// Returns the ± deviation of a JS tolerance, half of the tolerance of its grade, mm. [T10.21]
///
/// Errors    `distance_tolerance` if it is not JS1 to JS12; `center_distance` above 3150 mm
Result<double> js_deviation(std::string_view tolerance, double center_distance);

/// Returns the lower and the upper deviation of a hole or a keyway from its nominal size, mm.
///
/// Source    ISO 286-1, tables 1 and 3; ISO 286-2
/// Errors    `fit` if it is not H1 to H12, JS1 to JS12, N9 or P9; `size` if it exceeds 3150 mm, or
///           120 mm for N9 and P9
Result<std::array<double, 2>> hole_deviations(std::string_view fit, double size);

/// Returns the lower and the upper deviation of the tip diameter, mm. `side` is σ of the gear. The
/// tip of an external gear has the deviations of a shaft, whose signs are opposite to those of a
/// hole. The tip of an internal gear has the deviations of a hole.
///
/// Errors    `tolerance.tip_fit` if it is not h1 to h12 or js1 to js12, or for an internal gear not
///           H1 to H12 or JS1 to JS12; `tip_diameter` above 3150 mm
Result<std::array<double, 2>> tip_deviations(std::string_view fit, double tip_diameter,
                                             double side);

struct HubKeyway {
  double width;  ///< b    mm
  double depth;  ///< t_2  mm, from the bore
};

/// The least and the greatest bore of the table of hub_keyway(), mm.
inline constexpr std::array<double, 2> kKeyedBores{6.0, 380.0};

/// Returns the keyway of a bore of the diameter `bore`, mm, for the key that the table assigns to
/// this diameter. Returns none outside kKeyedBores.
///
/// Source    DIN 6885-1; values as printed in the catalogue Siemens MD 2009, "Parallel keys"
std::optional<HubKeyway> hub_keyway(double bore);

/// Returns the upper deviation of the depth of a keyway in a hub, mm. `width` is the width of the
/// keyway, mm. The lower deviation is 0.
///
/// Source    DIN 6885-1
double keyway_depth_deviation(double width);

}  // namespace gearwright
