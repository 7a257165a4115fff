// Makes the page of a workshop drawing with frame, title block, data table and the views of a part.
// The scale is the largest scale of ISO 5455 at which the views fit. Internal to cad/.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "gearwright/cad/gear_sheet.hpp"

namespace gearwright {

/// Works like length_text(), but rounds a computed length in mm to µm.
std::string computed_length_text(UnitSystem units, double mm);

/// The views of a part at one scale.
class SheetViews {
 public:
  virtual ~SheetViews() = default;
  /// Returns the box that the views occupy, relative to their origin.
  virtual SheetBox box() const = 0;
  virtual void draw(Sheet& sheet, const Vec2& origin) = 0;
};

struct SheetPage {
  const DrawingInput& words;
  const std::vector<DataGroup>& data;
  std::string number, mass;  ///< "1/2"; "0.41 kg", empty if unknown
  std::string datum;         ///< "axis of the bore"
  UnitSystem units;
  SheetSize size;
};

/// Draws the page. `views_at` makes the views for a scale, in mm on paper per mm on the part.
/// `deviation_mm` is the deviation of the outline.
GearSheet on_page(const SheetPage& page, double deviation_mm,
                  const std::function<std::unique_ptr<SheetViews>(double)>& views_at);

}  // namespace gearwright
