// The quantities of loaded contact, with torques, positions and probes. A result contains them
// under `load`.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/compliance/probe.hpp"
#include "gearwright/load/load_summary.hpp"

namespace gearwright {

struct ProbeView {
  const ProbeAnswer* answer;
  bool wide;  ///< true if the load covers the whole face width, in plane strain
};

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

struct LoadView {
  const LoadedContact* contact = nullptr;  ///< null if there are only probes
  std::vector<LoadStandard> standard{};    ///< values of the standard for each torque; empty if the
                                           ///< standard excludes the pair
  std::vector<ProbeView> probes{};
  std::vector<LoadView> halves{};  ///< the halves of a double-helical pair, z > 0 and z < 0
};

std::vector<LoadTorqueView> torque_views(const LoadedContact& contact,
                                         const std::vector<LoadStandard>& standard);

const Quantities<LoadView>& load_quantities();
const Quantities<LoadTorqueView>& load_torque_quantities();
const Quantities<LoadPositionView>& load_position_quantities();
/// The quantities of a tooth pair in point contact.
const Quantities<LoadedPair>& load_point_quantities();

}  // namespace gearwright
