// Torques in N m, as users read and write them, and in N mm, the internal unit.
#pragma once

#include "gearwright/base/units.hpp"

namespace gearwright {

/// N m of a torque in N mm.
constexpr double newton_metres(double torque) { return torque / kMmPerM; }
/// N mm of a torque in N m.
constexpr double from_newton_metres(double torque_Nm) { return torque_Nm * kMmPerM; }

}  // namespace gearwright
