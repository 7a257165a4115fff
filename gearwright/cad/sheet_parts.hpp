// The parts of a workshop drawing: frame, title block, table of data, dimensions. Internal to cad/.
//
// Frame and margins follow ISO 5457, the fields of the title block ISO 7200 and dimensions ISO
// 129-1. Words are above their line and are read from below or from the right.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gearwright/cad/gear_sheet.hpp"
#include "gearwright/cad/sheet.hpp"

namespace gearwright {

/// Heights of capitals, mm (ISO 3098-1).
inline constexpr double kSmall = 1.8, kUsual = 2.5, kLarge = 3.5;

/// Draws the frame and the centring marks of a sheet and returns the room within the frame.
SheetBox draw_frame(Sheet& sheet);

struct TitleBlock {
  const DrawingInput& words;
  std::string scale, format, number;  ///< "1:2", "A4", "1/2"
  std::string mass, datum;            ///< "0.41 kg", empty if unknown; "axis of the bore"
  UnitSystem units;                   ///< of the dimensions
};

/// Draws the title block at the lower right corner of `within`, 180 mm wide; returns the box that
/// it covers. A field without words is an empty cell.
SheetBox draw_title_block(Sheet& sheet, const SheetBox& within, const TitleBlock& block);

/// Returns the size in mm of the data table with this number of columns.
Vec2 data_size(const std::vector<DataGroup>& groups, int columns);
/// Draws the table with its upper left corner at `corner`.
void draw_data(Sheet& sheet, const Vec2& corner, const std::vector<DataGroup>& groups, int columns);

enum class Direction { across, up };

/// A length or a diameter between two edges, on a dimension line next to them.
struct Dimension {
  Direction direction;
  double begin, end;            ///< mm, along the direction; begin < end
  double edge_begin, edge_end;  ///< mm, positions of the edges, across it
  double line;                  ///< mm, position of the dimension line, across it
  std::string words;
};

/// The words are on the line if there is room between the edges. Otherwise they are beyond it:
/// after the end of a horizontal line, below a vertical one.
void draw_dimension(Sheet& sheet, const Dimension& dimension);

/// Words within a box, from the top. They are as large as possible, in several lines if necessary.
/// Words that do not fit end in an ellipsis.
void draw_words(Sheet& sheet, SheetLayer layer, const SheetBox& box, std::string_view words,
                double largest);

/// Returns true if the words fit completely into a box of that size.
bool words_fit(const Vec2& size, std::string_view words, double largest);

/// Draws lines at 45° through a box, which mark the section of a body.
void hatch(Sheet& sheet, const SheetBox& box);

}  // namespace gearwright
