// Describes the body of a gear. An external gear has a bore, and an internal gear has a rim.
#pragma once

#include <optional>

#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// The rim of an internal gear: as given, or by default 2.5 modules thick outside the root circle.
Bore rim(const Gear& ring);

/// A warning if no material remains between the bore and the roots, or between the roots and the
/// rim of an internal gear. The groove of a double-helical gear, with the diameter `groove` mm,
/// also limits the body.
std::optional<Warning> body_warning(const Gear& gear, std::optional<double> groove, int which);

}  // namespace gearwright
