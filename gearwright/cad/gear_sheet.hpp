// Makes the workshop drawing of a gear. The sheet contains the table of the data, the exact
// transverse section with bore and keyway, and an axial section with datum, runout and surface
// texture, within a frame with a title block.
//
// The table uses the symbols and terms of ISO 21771 in the order of DIN 3966-1. In the axial
// section, teeth are not hatched and the reference circle is a chain line (ISO 2203). The scale is
// the largest scale of ISO 5455 at which the views fit on the sheet.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/cad/sheet.hpp"
#include "gearwright/cad/toothed_body.hpp"
#include "gearwright/catalogue/drawing_keys.hpp"
#include "gearwright/catalogue/unit_system.hpp"

namespace gearwright {

enum class SheetSize { a4, a3 };

struct DataRow {
  std::string words, symbol, value;
};
struct DataGroup {
  std::string title;
  std::vector<DataRow> rows;
};

/// The requirements for the surfaces of a gear. If a text is empty, its symbol is drawn with an
/// empty space. If a texture is absent, no symbol is drawn.
struct SurfaceRequirements {
  std::optional<std::string> flank_texture, face_texture, bore_texture;  ///< "MRR Ra 0.8"
  std::string tip_runout, face_runout;  ///< circular runout to the axis, in the unit of the sheet
};

/// The content of the sheet of any part, apart from its shape.
struct SheetInput {
  DrawingInput words;                 ///< text of the title block, and the fits of bore and keyway
  std::vector<DataGroup> data;        ///< in the order of the table
  SurfaceRequirements surfaces;       ///< runout and texture, with symbols in the views
  std::string number;                 ///< number of the sheet, such as "1/2"
  UnitSystem units = UnitSystem::mm;  ///< unit of the dimensions; inches have four decimals
  std::string mass{};                 ///< "0.41 kg", empty if unknown
};

struct GearSheetInput : SheetInput {
  ToothedBody body;
  double reference_diameter;  ///< d    mm
  std::string tip_fit;        ///< fit of the tip diameter; empty if there is none
};

struct GearSheet {
  Sheet sheet;
  std::string scale;    ///< "1:2"
  double factor;        ///< the scale, mm on paper per mm on the gear
  double deviation_mm;  ///< deviation of the outline, mm on the gear
};

/// Returns a length in the unit of a sheet. Lengths in mm have at most four decimals. Lengths in
/// inches have exactly four decimals.
std::string length_text(UnitSystem units, double mm);

/// Makes the drawing of a gear. `tolerance_mm` is the tolerance of the outline, in mm on the gear.
///
/// Errors    those of dxf_drawing: a severed tooth, a bore that reaches the root circle, or an arc
///           that cannot be fitted within the tolerance
Result<GearSheet> gear_sheet(const GearSheetInput& input, SheetSize size, double tolerance_mm);

}  // namespace gearwright
