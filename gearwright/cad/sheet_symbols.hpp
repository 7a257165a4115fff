// Draws the graphical symbols of a workshop drawing for surface texture, runout, datum and edge.
// The symbols consist of lines and texts of a sheet, so every file format can contain them.
// Internal to cad/.
//
//   h   height of the capitals next to the symbols, 2.5 mm; lines are h/10 wide
//
// The shape and the proportions of each symbol are those of a standard. Surface texture follows
// ISO 1302, annex A (now ISO 21920-1). Tolerance frames (ISO 1101) and datums (ISO 5459) follow
// ISO 7083. Edges follow ISO 13715. If a text is empty, its symbol is drawn with an empty space.
#pragma once

#include <string>
#include <string_view>

#include "gearwright/cad/sheet.hpp"

namespace gearwright {

/// Heights of a texture symbol, of a tolerance frame, and of a datum with its triangle, mm.
inline constexpr double kTextureHeight = 7.5, kFrameHeight = 5.0, kDatumHeight = 9.5;
/// Half of the width of the box of a datum, mm.
inline constexpr double kDatumHalf = kFrameHeight / 2;

/// The letter of the only datum of a sheet, which is the axis of a gear or the back of a rack.
inline constexpr const char* kDatum = "A";

/// Return the extent of the symbol of a surface texture, such as "MRR Ra 0.8", to the left and to
/// the right of its point. The first word of the text selects the symbol. MRR gives a bar (material
/// is removed), and NMR gives a circle (no material is removed). APA, or a text without any of
/// these words, gives the basic symbol (any process). The symbol does not contain the selecting
/// word.
///
/// Units  mm
double texture_left();
double texture_right(std::string_view words);
/// Draws the symbol with its point at `foot`, upright.
void draw_texture(Sheet& sheet, const Vec2& foot, std::string_view words);

/// Returns the least width of the tolerance frame of a circular runout, mm.
double runout_width(std::string_view value);
/// Draws the frame with its lower left corner at `lo`. `width` is at least runout_width(value).
void draw_runout(Sheet& sheet, const Vec2& lo, double width, std::string_view value);

enum class DatumSide { above, below };

/// Draws the triangle of the datum on a line at `at`, with its box on the given side.
void draw_datum(Sheet& sheet, const Vec2& at, DatumSide side);

/// Draws the symbol of an edge, which is an angle with its corner at `corner`. `lengths` are the
/// signed lengths of the horizontal and the vertical line. The caller writes the permitted size of
/// the edge within the angle.
void draw_edge(Sheet& sheet, const Vec2& corner, const Vec2& lengths);

}  // namespace gearwright
