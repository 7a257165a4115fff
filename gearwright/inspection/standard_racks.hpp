// The standard racks that identify() tries, with their prior probabilities.
//
// Internal to inspection/.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/inspection/identify.hpp"

namespace gearwright::detail {

struct StandardRack {
  double module;  ///< m_n  mm
  double alpha;   ///< α_n  rad
  ModuleSeries series;
  std::optional<double> diametral_pitch;  ///< 1/in
  double log_prior;                       ///< logarithm of its prior probability
};

/// Modules of ISO 54 and diametral pitches, each with the usual pressure angles.
const std::vector<StandardRack>& standard_racks();
/// The measurement that distinguishes best between the likeliest gear and another one. None if only one
/// gear is left, or if no measurement distinguishes between the gears.
std::optional<NextMeasurement> next_measurement(const IdentifyProblem& problem,
                                                const std::vector<IdentifiedGear>& candidates);

}  // namespace gearwright::detail
