// The racks that gears are cut with, and how usual each is: what identify() tries.
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
  double log_prior;                       ///< logarithm of how usual it is
};

/// Modules of ISO 54 and diametral pitches, each with the pressure angles of its countries.
const std::vector<StandardRack>& standard_racks();

/// The reading that would decide best between the likeliest gear and another. None: one gear is left,
/// or nothing tells them apart.
std::optional<NextMeasurement> next_measurement(const IdentifyProblem& problem,
                                                const std::vector<IdentifiedGear>& candidates);

}  // namespace gearwright::detail
