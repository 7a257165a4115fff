// The data common to all gears, however they are cut: closed forms before the tooth, and warnings
// after it.
//
// Internal to gear/.
#pragma once

#include <string>

#include "gearwright/gear/gear.hpp"

namespace gearwright::detail {

/// Reference geometry, diameters from the rack, lead and pointed diameter: everything except the
/// tooth.
Gear described(const CylindricalSpec& spec);

/// Root and tip of the tooth as it was cut, and the warnings that follow.
void finish(Gear& gear);

void warn(Gear& gear, WarningCode code, std::string message);

}  // namespace gearwright::detail
