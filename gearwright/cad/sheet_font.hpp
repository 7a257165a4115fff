// The letters of a sheet: Helvetica, and Symbol for Greek letters and a few signs. Both belong to
// the 14 fonts that every PDF reader provides (PDF 1.4, 5.5.1). Their widths are published (Adobe,
// Core 14 AFM files).
//
// In a PDF, a letter that neither font contains is replaced by a question mark. SVG and DXF files
// contain the text itself, so the widths are used for the layout only.
#pragma once

#include <string_view>

namespace gearwright {

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

/// Units  mm; `height` is that of capitals; `text` is UTF-8
double text_width(std::string_view text, double height);

}  // namespace gearwright
