// Makes the workshop drawing of a rack. It contains the table of the data, the exact section, the
// view of an end and the plan, in first-angle projection.
//
// The datum is the back of the rack. The end view and the plan do not show teeth. Instead, the
// roots are a thin line, the datum line is a chain line, and three thin lines in the plan show the
// direction of helical teeth (ISO 2203). If a rack has more teeth than `kTeethInFull`, break lines
// (ISO 128) interrupt its views. The views then show only the teeth at both ends.
#pragma once

#include "gearwright/cad/gear_sheet.hpp"
#include "gearwright/pair/rack_pair.hpp"

namespace gearwright {

inline constexpr int kTeethInFull = 12;
inline constexpr int kTeethAtEnd = 3;  ///< drawn teeth at each end of an interrupted view

struct RackSheetInput : SheetInput {
  RackGeometry rack;
};

/// Makes the drawing of a rack. `tolerance_mm` is the tolerance of the outline, in mm on the rack.
///
/// Errors    the errors of rack_body(); `tolerance_mm` if an arc cannot be fitted within it
Result<GearSheet> rack_sheet(const RackSheetInput& input, SheetSize size, double tolerance_mm);

}  // namespace gearwright
