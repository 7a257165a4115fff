// An assembled drive in section that can be turned, and the meshes of its planets side by side.
// Internal to report/.
//
// One control turns everything. From t = 0 to 1, the drive makes the smallest motion after which it
// looks the same.
#pragma once

#include <string>

#include "gearwright/drive/drive_layout.hpp"

namespace gearwright {

/// The name under which the shape of a gear is defined (gear_shape.hpp).
std::string shape_name(std::size_t gear);

/// The shapes of all gears, each once.
std::string drive_definitions(const Drive& drive);

/// A section for each slot, true to scale, with the control, and below it the phases of the
/// planets.
std::string drive_section_figures(const Drive& drive, const DriveLayout& layout);

}  // namespace gearwright
