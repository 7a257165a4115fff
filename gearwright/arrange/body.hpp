// The body of a gear inside its teeth: its bore, or the rim of an internal gear.
#pragma once

#include <optional>

#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// The rim of an internal gear: as given, or one of 2.5 modules around its roots.
Bore rim(const Gear& ring);

/// A warning if there is no material between bore and roots, or between roots and rim of an
/// internal gear. A groove of the diameter `groove` mm, of a double-helical gear, is a limit too.
std::optional<Warning> body_warning(const Gear& gear, std::optional<double> groove, int which);

}  // namespace gearwright
