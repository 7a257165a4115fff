// Computes the data that do not depend on the kind of cutter: closed forms before the tooth is cut,
// and tip, root and warnings afterwards. Internal to gear/.
#pragma once

#include <string>

#include "gearwright/gear/gear.hpp"

namespace gearwright::detail {

/// Reference geometry, diameters from the rack, lead and pointed diameter: everything except the
/// tooth.
Gear described(const CylindricalSpec& spec);

/// Sets root and tip of the tooth as cut, and adds the warnings.
void finish(Gear& gear);

void warn(Gear& gear, WarningCode code, std::string message);

}  // namespace gearwright::detail
