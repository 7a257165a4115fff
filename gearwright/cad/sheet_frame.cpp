#include <algorithm>

#include "gearwright/cad/sheet_font.hpp"
#include "gearwright/cad/sheet_parts.hpp"

namespace gearwright {

namespace {

// mm, ISO 5457: the left margin is for filing.
constexpr double kFiling = 20, kMargin = 10, kMark = 5;
constexpr double kWidth = 180;  // of a title block, ISO 7200
constexpr double kFieldRow = 9, kTitle = 16;
constexpr double kFieldInset = 1.5;

struct Cell {
  double width;
  const char* label;
  std::string words;
};

// The room for words in a cell: below its label.
SheetBox room(const SheetBox& cell) {
  return {cell.lo + Vec2(kFieldInset, kFieldInset / 2),
          cell.hi - Vec2(kFieldInset, kFieldInset / 2 + kSmall + kFieldInset)};
}

// A row's height: taller where words would not fit, within limits.
double height_for(const std::vector<Cell>& cells, double height, double largest) {
  constexpr double kStep = 1, kMost = 24;
  const auto fits = [&](const Cell& cell) {
    const SheetBox box = room({{0, 0}, {cell.width, height}});
    return words_fit(box.hi - box.lo, cell.words, largest);
  };
  while (height < kMost && !std::all_of(cells.begin(), cells.end(), fits)) height += kStep;
  return height;
}

// One row of cells from `lo` up; the label stands above the words.
void draw_row(Sheet& sheet, const Vec2& lo, double height, const std::vector<Cell>& cells,
              double largest) {
  double x = lo.x();
  for (const Cell& cell : cells) {
    const SheetBox box{{x, lo.y()}, {x + cell.width, lo.y() + height}};
    sheet.rectangle(SheetLayer::data, box);
    const Vec2 label(x + kFieldInset, box.hi.y() - kFieldInset / 2 - kSmall);
    sheet.text(SheetLayer::data, label, cell.label, kSmall);
    draw_words(sheet, SheetLayer::data, room(box), cell.words, largest);
    x = box.hi.x();
  }
}

}  // namespace

SheetBox draw_frame(Sheet& sheet) {
  const Vec2 lo(kFiling, kMargin), hi = sheet.size - Vec2(kMargin, kMargin);
  sheet.rectangle(SheetLayer::frame, {lo, hi});
  const Vec2 middle = sheet.size / 2;
  const auto mark = [&](const Vec2& edge, const Vec2& inward) {
    sheet.line(SheetLayer::frame, edge, edge + inward);
  };
  mark({middle.x(), sheet.size.y() - kMargin + kMark}, {0, -kMark});
  mark({middle.x(), kMargin - kMark}, {0, kMark});
  mark({kFiling - kMark, middle.y()}, {kMark, 0});
  mark({sheet.size.x() - kMargin + kMark, middle.y()}, {-kMark, 0});
  return {lo, hi};
}

SheetBox draw_title_block(Sheet& sheet, const SheetBox& within, const TitleBlock& block) {
  const DrawingInput& w = block.words;
  const double x = within.hi.x() - kWidth;
  double y = within.lo.y();
  const auto row = [&](double least, const std::vector<Cell>& cells, double largest) {
    const double height = height_for(cells, least, largest);
    draw_row(sheet, {x, y}, height, cells, largest);
    y += height;
  };
  row(kFieldRow,
      {{40, "Scale", block.scale},
       {60, "Dimensions in", "mm, angles in degrees"},
       {40, "Format", block.format},
       {40, "Sheet", block.number}},
      kUsual);
  row(kTitle, {{125, "Title", w.title}, {55, "Drawing number", w.number}}, kLarge);
  row(kFieldRow, {{90, "Material", w.material}, {50, "Author", w.author}, {40, "Date", w.date}},
      kUsual);
  if (!w.note.empty()) row(kFieldRow, {{kWidth, "Note", w.note}}, kUsual);
  const SheetBox all{{x, within.lo.y()}, {within.hi.x(), y}};
  sheet.rectangle(SheetLayer::frame, all);
  return all;
}

}  // namespace gearwright
