// Describes a drawing on paper by lines, arcs, circles and text on named layers, in mm. The lower
// left corner of the sheet is (0, 0). The x axis points to the right and the y axis upwards. PDF,
// SVG and DXF files are written from such a sheet (sheet_files.hpp).
//
//   h    height of capitals, mm (ISO 3098). The font is Helvetica. A layout can avoid overlaps of
//        text and lines, because text_width() computes the width of a text.
//   b    bulge of a segment of a path: tan(sweep/4), > 0 counter-clockwise, 0 for a line
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/base/vector.hpp"

namespace gearwright {

enum class SheetLayer { outline, hatch, axis, dimension, data, frame };
inline constexpr int kSheetLayers = 6;

struct LayerStyle {
  const char* name;   ///< name of the layer in a DXF file
  double line_width;  ///< mm, ISO 128
  bool chain;         ///< line of long dashes and dots, for axes and reference circles
  int dxf_color;      ///< AutoCAD colour index
};
const LayerStyle& style_of(SheetLayer layer);
/// Lengths of dash, gap, dot and gap, mm (ISO 128-2, line type 04 with a width of 0.25 mm).
inline constexpr double kChain_mm[] = {6.0, 1.0, 0.5, 1.0};

struct SheetBox {
  Vec2 lo, hi;  ///< mm
};

/// The look of a mark of a figure (figure_files.hpp). A mark of a drawing has no SheetInk. The
/// layer of such a mark determines its look.
struct SheetInk {
  std::string name;                           ///< name of the layer in a DXF file
  std::optional<std::uint32_t> fill, stroke;  ///< 0xRRGGBB; absent if there is none
  double fill_opacity, stroke_opacity;
  double line_width;           ///< mm
  std::vector<double> dashes;  ///< mm
  bool even_odd;  ///< true if areas are filled by the even-odd rule, false if by the non-zero rule
};

struct SheetPath {
  SheetLayer layer;
  std::vector<Vec2> points;    ///< mm
  std::vector<double> bulges;  ///< bulges[i]: segment from points[i] to the next point
  bool closed = false;
  bool filled = false;                            ///< true for an arrow head, a black triangle
  std::shared_ptr<const SheetInk> ink = nullptr;  ///< null for a mark of a drawing
  bool more = false;                  ///< true if the next path is a further piece of the same area
  std::optional<SheetBox> clip = {};  ///< the visible part; absent if the whole sheet is visible
};

struct SheetCircle {
  SheetLayer layer;
  Vec2 center;    ///< mm
  double radius;  ///< mm
};

struct SheetText {
  SheetLayer layer;
  Vec2 at;  ///< mm, left end of the base line
  std::string text;
  double height;         ///< h  mm
  bool upright = false;  ///< true for text that runs upwards, to be read from the right
  std::shared_ptr<const SheetInk> ink = nullptr;  ///< null for a text of a drawing
  bool slanted = false;                           ///< true for a symbol of a formula
};

enum class Along { start, middle, end };

struct Sheet {
  Vec2 size;  ///< mm
  std::vector<SheetPath> paths = {};
  std::vector<SheetCircle> circles = {};
  std::vector<SheetText> texts = {};
  Vec2 corner = Vec2::Zero();  ///< mm, the lower left corner; zero for a drawing

  void line(SheetLayer layer, const Vec2& a, const Vec2& b);
  void rectangle(SheetLayer layer, const SheetBox& box);
  void circle(SheetLayer layer, const Vec2& center, double radius);
  /// Adds a filled arrow head with its point at `tip`.
  void arrow(SheetLayer layer, const Vec2& tip, const Vec2& direction);
  void text(SheetLayer layer, const Vec2& at, std::string_view words, double height,
            Along along = Along::start);
  /// Adds a text that runs upwards and is read from the right. `along` is the alignment in this
  /// direction.
  void upright_text(SheetLayer layer, const Vec2& at, std::string_view words, double height,
                    Along along);
  /// Adds a symbol with a subscript, such as "α_n".
  void symbol(SheetLayer layer, const Vec2& at, std::string_view symbol, double height);
};

/// Units  mm
double symbol_width(std::string_view symbol, double height);

/// Returns the box around a text, including capitals and descenders.
SheetBox box_of(const SheetText& text);

// Most letters of a sheet are those of the font Helvetica. Greek letters and a few signs are those
// of the font Symbol. Both fonts belong to the 14 fonts that every PDF reader provides (PDF 1.4,
// 5.5.1). The widths of their letters are published (Adobe, Core 14 AFM files).

enum class SheetFont { helvetica, symbol };

struct SheetLetter {
  SheetFont font;
  unsigned char code;  ///< WinAnsi code in Helvetica, or Symbol's own code
  int width;           ///< thousandths of the font size
  bool known;          ///< if false, a question mark replaces the letter
};

SheetLetter letter_of(char32_t code);

/// Height of capitals relative to the font size, and depth of descenders relative to the height of
/// capitals.
inline constexpr double kCapital = 0.718;
inline constexpr double kDescent = 0.21 / kCapital;

/// Units  mm; `height` is the height of capitals; `text` is UTF-8
double text_width(std::string_view text, double height);

}  // namespace gearwright
