// Pictures of an assembled drive: sections of the drive whose gears the user can turn, and the
// meshes of the planets side by side. Internal to report/.
//
// One control turns all pictures. While t runs from 0 to 1, the drive makes the smallest motion
// after which it looks the same as before.
#pragma once

#include <string>

#include "gearwright/catalogue/unit_system.hpp"
#include "gearwright/drive/drive_layout.hpp"

namespace gearwright {

/// The name of the SVG definition that contains the shape of a gear (gear_shape.hpp).
std::string shape_name(std::size_t gear);

/// The SVG definitions of the shapes of all gears.
std::string drive_definitions(const Drive& drive);

/// A figure for each axial section, true to scale, followed by the phases of the planets. The first
/// figure has the control that turns the gears.
std::string drive_section_figures(const Drive& drive, const DriveLayout& layout, UnitSystem units);

}  // namespace gearwright
