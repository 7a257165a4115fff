// The quantities of loaded contact, with torques, positions and probes. A result contains them
// under `load`.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/arrange/loaded_pair.hpp"
#include "gearwright/catalogue/quantity.hpp"

namespace gearwright {

struct LoadPositionView {
  const LoadedTorque* torque;
  const LoadedPosition* position;
  LoadRegime regime;
};

struct LoadTorqueView {
  const LoadedTorque* torque;
  const LoadedContact* all;
  std::optional<LoadStandard> standard;
};

std::vector<LoadTorqueView> torque_views(const LoadedContact& contact,
                                         const std::vector<LoadStandard>& standard);

const Quantities<LoadAnalysis>& load_quantities();
const Quantities<LoadTorqueView>& load_torque_quantities();
const Quantities<LoadPositionView>& load_position_quantities();
const Quantities<LoadedPair>& load_point_quantities();

}  // namespace gearwright
