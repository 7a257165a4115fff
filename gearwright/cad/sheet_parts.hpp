// Draws the parts of a workshop drawing, which are frame, title block, data table and dimensions.
// Only files of cad/ include this header.
//
// Frame and margins follow ISO 5457, the fields of the title block follow ISO 7200, and dimensions
// follow ISO 129-1. Text is placed above its line and is read from below or from the right.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gearwright/cad/gear_sheet.hpp"
#include "gearwright/cad/sheet.hpp"

namespace gearwright {

/// Heights of capitals, mm (ISO 3098-1).
inline constexpr double kSmall = 1.8, kUsual = 2.5, kLarge = 3.5;

/// Draws the frame and the centring marks of a sheet. Returns the space within the frame.
SheetBox draw_frame(Sheet& sheet);

struct TitleBlock {
  const SheetInput& part;
  std::string scale, format, datum;  ///< "1:2", "A4", "axis of the bore"
};

/// Draws the title block, 180 mm wide, at the lower right corner of `within`. Returns the box that
/// it covers. A field without text is an empty cell.
SheetBox draw_title_block(Sheet& sheet, const SheetBox& within, const TitleBlock& block);

/// Returns the size in mm of the data table with this number of columns.
Vec2 data_size(const std::vector<DataGroup>& groups, int columns);
/// Draws the table with its upper left corner at `corner`.
void draw_data(Sheet& sheet, const Vec2& corner, const std::vector<DataGroup>& groups, int columns);

enum class Direction { across, up };

/// A length or a diameter between two edges. The dimension line is next to the edges.
struct Dimension {
  Direction direction;
  double begin, end;            ///< mm, along the dimension line; begin < end
  double edge_begin, edge_end;  ///< mm, positions of the edges, perpendicular to the dimension line
  double line;                  ///< mm, position of the dimension line, measured like edge_begin
  std::string words;
  bool datum = false;  ///< true if the axis of this diameter is the datum; only with Direction::up
};

/// True if there is room for the text between the edges.
bool has_room(const Dimension& dimension);

/// The lowest and the highest point of a vertical dimension, including its text and its datum, mm.
struct Reach {
  double lo, hi;
};
Reach reach_of(const Dimension& dimension);

/// Draws a dimension. If there is room between the edges, its text is above the dimension line, and
/// its datum is at the lower end. If there is no room, the text is beyond the right end of a
/// horizontal dimension line, or beyond the lower end of a vertical one. The datum is then at the
/// upper end.
void draw_dimension(Sheet& sheet, const Dimension& dimension);

/// Draws text within a box, starting at the top. The letters are as large as possible, but at most
/// `largest` mm high. The function uses several lines if necessary. If the text does not fit, it
/// ends in an ellipsis.
void draw_words(Sheet& sheet, SheetLayer layer, const SheetBox& box, std::string_view words,
                double largest);

bool words_fit(const Vec2& size, std::string_view words, double largest);

/// Fills a box with lines at 45°, which mark the section of a body.
void hatch(Sheet& sheet, const SheetBox& box);

}  // namespace gearwright
