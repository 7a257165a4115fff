// The pictures of teeth under load. Of several torques each has its curve; pressures and stresses are
// those of the heaviest.
#pragma once

#include <array>
#include <string>

#include "gearwright/contact/pattern.hpp"
#include "gearwright/report/load_report.hpp"

namespace gearwright {

/// Transmission error, load shares and stiffness while the gears turn: one figure each.
std::string loaded_te_figure(const LoadReport& report);
std::string share_figure(const LoadReport& report);
std::string stiffness_figure(const LoadReport& report);
/// What changes with the torque, the Harris map; empty with one torque.
std::string harris_figure(const LoadReport& report);

/// The greatest pressure over a mesh on gear `which` (0, 1), MPa in place of the gap: 0 where nothing
/// presses. Between positions and slices it is linear.
FlankRaster pressure_raster(const LoadReport& report, std::size_t which);

/// Where teeth press: the greatest pressure at each place of the flanks of both gears over a mesh, and
/// with one slider the lines along which they bear now; below them the pressure along the face.
std::string pressure_figures(const LoadReport& report);

/// Teeth that touch about points: the ellipses of a tooth on its way through the mesh, on both flanks,
/// and how hard it presses meanwhile.
///
/// Domain    teeth that touch at points, at least one position in contact (contract)
std::string ellipse_figures(const LoadReport& report);

/// Stress at the roots, along the drawn fillet of each gear and over the face. `shapes` are the gears'
/// in the page's definitions (gear_shape.hpp).
std::string root_stress_figures(const LoadReport& report, const std::array<std::string, 2>& shapes);

}  // namespace gearwright
