// The body of a gear inside its teeth: its bore, or the rim of an internal gear.
#pragma once

#include <optional>

#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// The rim of an internal gear: the given one, or by default a rim 2.5 modules thick outside the roots.
Bore rim(const Gear& ring);

/// A warning if there is no material between bore and roots, or between roots and rim of an
/// internal gear. The groove of a double-helical gear, of diameter `groove` mm, limits the body too.
std::optional<Warning> body_warning(const Gear& gear, std::optional<double> groove, int which);

}  // namespace gearwright
