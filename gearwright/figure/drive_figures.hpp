// Pictures of a whole drive: its kinematic scheme and its power flow.
//
// Each body has a colour of its own, the same in every picture of one drive.
#pragma once

#include <optional>
#include <string>

#include "gearwright/drive/drive_places.hpp"
#include "gearwright/figure/figure.hpp"

namespace gearwright {

/// The class of a body's colour: "b0" to "b7", then "b0" again.
std::string body_style(std::size_t body);

/// The scheme of the drive in a half section: gears as bars, shafts, carriers with one planet of
/// each kind, fixed bodies, with speeds and torques at the ends of shafts. Coaxial shafts are drawn beside
/// each other. Radii are to scale, lengths are not.
Figure scheme_figure(const Drive& drive, const DrivePlaces& places);

/// Diagram of the power flow from the inputs through bodies and meshes to the output. There is none
/// if no power flows or if the drive is self-locking.
std::optional<Figure> power_figure(const Drive& drive);

}  // namespace gearwright
