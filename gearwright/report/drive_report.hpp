// Writes one HTML page about a whole drive. The page begins with the verdict, the scheme, sections
// of the drive with a control that turns the gears, and the phases of the planets. After these
// follow the power flow, the strength, the load, the planets, each mesh as a pair of gears, the
// gears, and the files.
//
// The laws of report_html() hold for this page too.
#pragma once

#include <string>

#include "gearwright/catalogue/unit_system.hpp"
#include "gearwright/drive/drive_layout.hpp"
#include "gearwright/report/report.hpp"

namespace gearwright {

struct DriveReportInput : PageInput {
  const Drive* drive = nullptr;
  const DrivePlaces* places = nullptr;  ///< null (no scheme) if the axes cannot be placed
  const DriveLayout* layout = nullptr;  ///< null if the drive cannot be assembled
  std::string why_no_layout;            ///< if `layout` is null, the reason, as a sentence
};

/// Returns the page in UTF-8.   Domain a drive (contract)
std::string drive_report_html(const DriveReportInput& input);

// Draws pictures of an assembled drive. They are sections of the drive whose gears the user can
// turn, and the meshes of the planets side by side.
//
// One control turns all pictures. While t runs from 0 to 1, the drive makes the smallest motion
// after which it looks the same as before, or one turn of the input if this motion is unknown. A
// drive with a rack moves to and fro instead, while t runs from −1/2 to 1/2 and back.

/// Returns the name of the SVG definition that contains the shape of a gear (gear_shape.hpp) or of
/// a rack (rack_mesh.hpp).
std::string shape_name(std::size_t gear);

/// Returns the name of the shape that represents a rack in one mesh. A rack with several meshes has
/// another shape for each mesh after the first, because the length of a path unit depends on the
/// pinion. If gear 2 is not a rack, the result is shape_name() of gear 2.
std::string rack_shape_name(const Drive& drive, std::size_t mesh);

std::string drive_definitions(const Drive& drive);

/// Returns a figure for each axial section, true to scale, followed by the phases of the planets.
/// The first figure has the control that turns the gears.
std::string drive_section_figures(const Drive& drive, const DriveLayout& layout, UnitSystem units);

}  // namespace gearwright
