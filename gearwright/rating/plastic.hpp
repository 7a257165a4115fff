// Rates root and flank of plastic gears to VDI 2736, part 2, at the temperatures of the teeth.
//
//   ϑ_Fla, ϑ_Fu   temperatures of flank and root, °C       ϑ_0   ambient temperature, °C
//   H_V           degree of tooth loss                     μ     coefficient of friction
//   k_ϑ           heat transfer of the teeth, K (m/s)^0.75 mm^1.75/W
//   R_λG, A_G     thermal resistance, K m²/W, and surface, m², of the housing
//   ED            relative duty
//                                              theory: docs/theory/11-rating.md
//
// Wear, deformation of the teeth and peak loads are not covered.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/rating/factor.hpp"
#include "gearwright/rating/material.hpp"
#include "gearwright/rating/rated_pair.hpp"

namespace gearwright {

/// Temperatures of the teeth, or the data from which they are computed.
struct PlasticInput {
  std::optional<std::array<double, 2>> flank_temperature, root_temperature;  ///< °C
  std::optional<double> ambient_temperature;                                 ///< ϑ_0  °C
  std::optional<double> friction;                                            ///< μ
  double housing_resistance = 0.0;            ///< R_λG  K m²/W; 0 for an open housing
  std::optional<double> housing_area;         ///< A_G   m²; if absent, `housing_resistance` has no
                                              ///< effect
  double duty = 1.0;                          ///< ED
  std::optional<double> flank_heat_transfer;  ///< k_ϑ of the flank
  std::optional<double> root_heat_transfer;   ///< k_ϑ of the root
};

/// Temperatures of flank and root of both gears, °C. Temperatures of a metal gear are present only
/// if the user gives them.
struct ToothTemperatures {
  FactorPair flank, root;
};

/// Returns H_V of a pair, computed from its partial contact ratios.
///
/// Formula   [T11.44]
double tooth_loss(const RatedPair& pair);

struct RatingInput;
struct Rating;

std::vector<Error> missing_plastic_inputs(const RatingInput& input);
/// Rates a pair to VDI 2736. rate() calls this function. The values of the result are in the order
/// pinion, wheel.
///
/// Formula   [T11.45]…[T11.47]
Result<Rating> rate_plastic(const RatedPair& pair, const RatingInput& input);

}  // namespace gearwright
