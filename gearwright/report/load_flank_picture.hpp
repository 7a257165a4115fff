// Where teeth press under load: the greatest pressure at each place of the flanks over a mesh, and
// with the slider the lines along which they bear now.
#pragma once

#include <string>

#include "gearwright/contact/pattern.hpp"
#include "gearwright/report/load_report.hpp"

namespace gearwright {

/// The greatest pressure over a mesh on gear `which` (0, 1), MPa in place of the gap: 0 where nothing
/// presses. Between positions and slices it is linear.
FlankRaster pressure_raster(const LoadReport& report, std::size_t which);

/// The flanks of both gears and the pressure along the face, with one slider.
std::string pressure_figures(const LoadReport& report);

}  // namespace gearwright
