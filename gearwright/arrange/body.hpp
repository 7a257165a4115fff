// What a gear's body is inside its teeth: its bore, or of an internal gear its rim.
#pragma once

#include <optional>

#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// The rim of an internal gear: as given, or one of 2.5 modules around its roots.
Bore rim(const Gear& ring);

/// No material between bore and roots, of an internal gear between roots and rim.
std::optional<Warning> body_warning(const Gear& gear, int which);

}  // namespace gearwright
