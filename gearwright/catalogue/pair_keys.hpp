// The keys of [pair]: how the two gears are mounted.
#pragma once

#include <optional>

#include "gearwright/base/angle.hpp"
#include "gearwright/catalogue/key.hpp"
#include "gearwright/pair/shift.hpp"

namespace gearwright {

/// [pair]
struct PairInput {
  std::optional<double> center_distance;  ///< a  mm
  std::optional<Angle> shaft_angle;       ///< Σ, signed
  Mounting mounting = Mounting::tight;
  bool shorten_tips = false;  ///< tips cut back by k m_n, where no tip diameter is given
  std::optional<double> friction_coefficient;  ///< μ
  std::optional<double> speed_rpm;             ///< n_1  1/min
};

const KeyTable& pair_keys();

}  // namespace gearwright
