// Sheets of paper as files. The same sheets give the same bytes, because the files contain no time
// and no host name.
//
//   PDF   1.4, a page for each sheet; Helvetica and Symbol, which no file needs to carry
//   SVG   in mm, the sheets side by side; every word has its width, so that another font of the
//         reader's keeps within it
//   DXF   AutoCAD 2000, in mm of the paper, the sheets side by side; layers and line types by name,
//         words are TEXT entities
#pragma once

#include <string>
#include <vector>

#include "gearwright/cad/sheet.hpp"

namespace gearwright {

/// Distance between adjacent sheets, mm.
inline constexpr double kBetweenSheets_mm = 20.0;

struct SheetWords {
  std::string title, author;  ///< of the file; empty: none
};

/// Domain    at least one sheet (contract), here and below
/// Accuracy  0.15 µm on paper
std::string sheets_pdf(const std::vector<Sheet>& sheets, const SheetWords& words);
/// Number of letters that no font of a PDF contains and that become question marks there.
int letters_not_in_pdf(const std::vector<Sheet>& sheets);

std::string sheets_svg(const std::vector<Sheet>& sheets, const SheetWords& words);
std::string sheets_dxf(const std::vector<Sheet>& sheets);

}  // namespace gearwright
