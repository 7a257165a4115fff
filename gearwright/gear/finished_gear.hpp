// What every gear has, however it was cut: closed forms before the tooth, and what it means after.
//
// Internal to gear/.
#pragma once

#include <string>

#include "gearwright/gear/gear.hpp"

namespace gearwright::detail {

/// Reference geometry, diameters of the rack, lead, point: all but the tooth.
Gear described(const CylindricalSpec& spec);

/// Root and tip of the tooth as it was cut, and the warnings that follow.
void finish(Gear& gear);

void warn(Gear& gear, WarningCode code, std::string message);

}  // namespace gearwright::detail
