// The keys of [pair], which describe the mounting of the two gears.
#pragma once

#include <optional>

#include "gearwright/arrange/given_pair.hpp"
#include "gearwright/base/angle.hpp"
#include "gearwright/catalogue/key.hpp"

namespace gearwright {

const KeyTable& pair_keys();

/// The keys of [gear2] if gear 2 is a rack.
const KeyTable& rack_bar_keys();

// The keys of [fit], which are the inputs of the verb `fit` in addition to the gears and the pair.

/// [fit]
struct FitInput {
  std::optional<Angle> working_normal_pressure_angle;  ///< α_wn of the requested designs
  bool few_teeth = false;  ///< true for a pinion with circular fillets and the wheel that it cuts
  std::optional<double> min_tip_land, min_gap, clearance, backlash;  ///< mm, for few_teeth
  std::optional<double> contact_ratio;                               ///< total contact ratio, for
                                                                     ///< few_teeth
};

const KeyTable& fit_keys();

}  // namespace gearwright
