// Writes sheets of paper as files. The files contain no time and no host name, so the same sheets
// give the same bytes.
//
//   PDF   1.4, one page per sheet; the fonts are Helvetica and Symbol, which need not be embedded
//   SVG   in mm, the sheets side by side; the file states the width of every text, so that a
//         substitute font keeps this width
//   DXF   AutoCAD 2000, in mm on paper, the sheets side by side; layers and line types have names;
//         texts are TEXT entities
#pragma once

#include <string>
#include <vector>

#include "gearwright/cad/sheet.hpp"

namespace gearwright {

/// Distance between adjacent sheets, mm.
inline constexpr double kBetweenSheets_mm = 20.0;

struct SheetWords {
  std::string title, author;  ///< title and author of the file; empty if there is none
};

/// Domain    at least one sheet (contract), for all functions below
/// Accuracy  0.15 µm on paper
std::string sheets_pdf(const std::vector<Sheet>& sheets, const SheetWords& words);
/// Returns the number of letters that neither font of the PDF contains. The PDF shows a question
/// mark for each of them.
int letters_not_in_pdf(const std::vector<Sheet>& sheets);

std::string sheets_svg(const std::vector<Sheet>& sheets, const SheetWords& words);
std::string sheets_dxf(const std::vector<Sheet>& sheets);

}  // namespace gearwright
