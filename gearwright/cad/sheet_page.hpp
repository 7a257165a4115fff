// Makes the page of a workshop drawing with frame, title block, data table and the views of a part.
// The scale is the largest scale of ISO 5455 at which the views fit. Internal to cad/.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "gearwright/cad/gear_sheet.hpp"
#include "gearwright/cad/sheet_parts.hpp"

namespace gearwright {

/// Works like length_text(), but rounds a computed length in mm to µm.
std::string computed_length_text(UnitSystem units, double mm);

/// The views of a part at one scale.
class SheetViews {
 public:
  virtual ~SheetViews() = default;
  /// Returns the box that the views occupy, relative to their origin.
  virtual SheetBox box() const = 0;
  void draw_at(Sheet& sheet, const Vec2& origin) {
    sheet_ = &sheet;
    origin_ = origin;
    draw();
  }

 protected:
  virtual void draw() = 0;
  // The positions of lines and dimensions are relative to the origin.
  void line(SheetLayer layer, const Vec2& a, const Vec2& b) {
    sheet_->line(layer, origin_ + a, origin_ + b);
  }
  void add(Dimension dimension);

  Sheet* sheet_ = nullptr;
  Vec2 origin_ = Vec2::Zero();
};

/// Draws the page. `datum` is the text of the datum, such as "axis of the bore". `views_at` makes
/// the views for a scale, in mm on paper per mm on the part. `deviation_mm` is the deviation of the
/// outline.
GearSheet on_page(const SheetInput& part, const std::string& datum, SheetSize size,
                  double deviation_mm,
                  const std::function<std::unique_ptr<SheetViews>(double)>& views_at);

}  // namespace gearwright
