// The letters of a sheet: Helvetica, and Symbol for Greek and a few signs, of the 14 fonts that every
// reader of PDF has (PDF 1.4, 5.5.1); their widths are published with them (Adobe, Core 14 AFM files).
//
// A letter of a title that neither font contains is a question mark in PDF. SVG and DXF contain the
// text itself, and the widths here are used for the layout only.
#pragma once

#include <string_view>

namespace gearwright {

enum class SheetFont { helvetica, symbol };

struct SheetLetter {
  SheetFont font;
  unsigned char code;  ///< WinAnsi of Helvetica, Symbol's own
  int width;           ///< thousandths of the size
  bool known;          ///< false: a question mark replaces it
};

SheetLetter letter_of(char32_t code);

/// Height of capitals relative to the size, and depth of descenders relative to the height of
/// capitals.
inline constexpr double kCapital = 0.718;
inline constexpr double kDescent = 0.21 / kCapital;

/// Units  mm, `height` of capitals. UTF-8
double text_width(std::string_view text, double height);

}  // namespace gearwright
