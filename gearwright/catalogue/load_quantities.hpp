// The quantities of loaded contact: `load` of a result, its torques, positions and probes.
#pragma once

#include <vector>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/compliance/probe.hpp"
#include "gearwright/load/loaded_contact.hpp"

namespace gearwright {

struct ProbeView {
  const ProbeAnswer* answer;
  bool wide;  ///< the whole face in plane strain
};

struct LoadPositionView {
  const LoadedTorque* torque;
  const LoadedPosition* position;
};

struct LoadTorqueView {
  const LoadedTorque* torque;
  const LoadedContact* all;
};

struct LoadView {
  const LoadedContact* contact = nullptr;  ///< null: only probes
  std::vector<ProbeView> probes;
};

const Quantities<LoadView>& load_quantities();
const Quantities<LoadTorqueView>& load_torque_quantities();
const Quantities<LoadPositionView>& load_position_quantities();

}  // namespace gearwright
