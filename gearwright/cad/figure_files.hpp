// Writes figures as PDF and DXF files, for papers and for CAD.
//
// The SVG text of a figure is read together with figure_style.css and becomes a sheet. The writers
// of drawings make the files from this sheet, so all files of a figure have one layout and one
// table of styles. If the user has turned or zoomed a picture on the page, the file shows it in
// this view. The colours are the colours for paper.
#pragma once

#include <string>

#include "gearwright/base/result.hpp"
#include "gearwright/cad/sheet.hpp"
#include "gearwright/figure/figure.hpp"

namespace gearwright {

struct PictureScale {
  double mm_per_px;
  Vec2 corner = Vec2::Zero();  ///< mm, the lower left corner of the picture
  bool outlines = false;       ///< true if the areas of gears are not filled
};

/// Converts a picture to a sheet.
///
/// Domain    a picture that figure_svg() has written; any other text may cause an exception
Sheet picture_sheet(const std::string& svg, const PictureScale& scale);

/// Returns a PDF with one page of the size of the picture, 0.75 pt per px.
std::string picture_pdf(const std::string& svg, const std::string& title);

/// Returns the contents of a file of the figure. `ending` selects the format: ".svg", ".pdf" or
/// ".dxf". A DXF file has the scale 1 : 1, and its layers are the classes of the marks.
///
/// Errors    another ending; ".dxf" for a figure with axes
Result<std::string> figure_file(const Figure& figure, const std::string& ending);

}  // namespace gearwright
