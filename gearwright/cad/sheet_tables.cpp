#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "gearwright/cad/sheet.hpp"
#include "gearwright/cad/sheet_parts.hpp"
#include "gearwright/cad/sheet_symbols.hpp"
#include "gearwright/figure/markup.hpp"

namespace gearwright {

namespace {

// Lengths in mm. A row has the height kRow. The term, the symbol and the value have the widths
// kWords, kSymbol and kValue. Two columns of the table are kBetween from each other.
constexpr double kRow = 4.8, kWords = 41, kSymbol = 11, kValue = 36, kBetween = 4;
constexpr double kColumn = kWords + kSymbol + kValue;
// Distance of a text from the left edge of its cell, and of its base line from the lower edge, mm.
constexpr double kInset = 1.2, kBase = 1.4;

double rows_of(const DataGroup& group) { return 1.0 + static_cast<double>(group.rows.size()); }

// Returns the number of groups in the first column. With this number, the longer of the two columns
// is as short as possible.
std::size_t second_column(const std::vector<DataGroup>& groups) {
  double all = 0.0, before = 0.0, best = std::numeric_limits<double>::infinity();
  for (const DataGroup& g : groups) all += rows_of(g);
  std::size_t at = 0;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    before += rows_of(groups[i]);
    const double longest = std::max(before, all - before);
    if (longest < best) {
      best = longest;
      at = i + 1;
    }
  }
  return at;
}

using Columns = std::vector<std::vector<const DataGroup*>>;

Columns split(const std::vector<DataGroup>& groups, int columns) {
  Columns result(static_cast<std::size_t>(columns));
  const std::size_t second = columns == 1 ? groups.size() : second_column(groups);
  for (std::size_t i = 0; i < groups.size(); ++i) result[i < second ? 0 : 1].push_back(&groups[i]);
  return result;
}

// Returns the usual letter height. If the text would be wider than `width`, the height is reduced.
// `natural_width` is the width of the text at the usual height.
double fitted(double natural_width, double width) {
  return kUsual * std::min(1.0, width / natural_width);
}
void in_line(Sheet& sheet, const Vec2& at, std::string_view words, double width) {
  sheet.text(SheetLayer::data, at, words, fitted(text_width(words, kUsual), width));
}

void draw_group(Sheet& sheet, double x, double& y, const DataGroup& group) {
  const auto rule = [&](SheetLayer layer) { sheet.line(layer, {x, y}, {x + kColumn, y}); };
  rule(SheetLayer::frame);
  y -= kRow;
  in_line(sheet, {x + kInset, y + kBase}, group.title, kColumn - 2 * kInset);
  rule(SheetLayer::frame);
  const double top = y;
  for (const DataRow& row : group.rows) {
    y -= kRow;
    const double base = y + kBase;
    in_line(sheet, {x + kInset, base}, row.words, kWords - 2 * kInset);
    const double symbol = fitted(symbol_width(row.symbol, kUsual), kSymbol - 2 * kInset);
    sheet.symbol(SheetLayer::data, {x + kWords + kInset, base}, row.symbol, symbol);
    in_line(sheet, {x + kWords + kSymbol + kInset, base}, row.value, kValue - 2 * kInset);
    if (&row != &group.rows.back()) rule(SheetLayer::data);
  }
  for (const double column : {kWords, kWords + kSymbol})
    sheet.line(SheetLayer::data, {x + column, top}, {x + column, y});
}

// Lengths in mm (ISO 5457). The left margin kFiling is wider than the other margins kMargin, for
// filing. The centring marks have the length kMark.
constexpr double kFiling = 20, kMargin = 10, kMark = 5;
constexpr double kWidth = 180;  // width of a title block, ISO 7200
constexpr double kFieldRow = 9, kTitle = 16;
constexpr double kFieldInset = 1.5;

struct Cell {
  double width;
  const char* label;
  std::string words;
  bool edge = false;  // true if the text is within the symbol of an edge
};

// Returns the space for text in a cell, below the label. The symbol of an edge runs along the left
// and the lower side of this space.
SheetBox room(const SheetBox& box, const Cell& cell) {
  const Vec2 symbol = cell.edge ? Vec2(1, 0.4) : Vec2(0, 0);
  return {box.lo + Vec2(kFieldInset, kFieldInset / 2) + symbol,
          box.hi - Vec2(kFieldInset, kFieldInset / 2 + kSmall + kFieldInset)};
}

// Returns the height of a row. If a text does not fit, the height is increased up to a limit.
double height_for(const std::vector<Cell>& cells, double height, double largest) {
  constexpr double kStep = 1, kMost = 24;
  const auto fits = [&](const Cell& cell) {
    const SheetBox box = room({{0, 0}, {cell.width, height}}, cell);
    return words_fit(box.hi - box.lo, cell.words, largest);
  };
  while (height < kMost && !std::all_of(cells.begin(), cells.end(), fits)) height += kStep;
  return height;
}

// Draws a row of cells from left to right. `lo` is the lower left corner of the row. The label of a
// cell is above its text.
void draw_row(Sheet& sheet, const Vec2& lo, double height, const std::vector<Cell>& cells,
              double largest) {
  double x = lo.x();
  for (const Cell& cell : cells) {
    const SheetBox box{{x, lo.y()}, {x + cell.width, lo.y() + height}};
    sheet.rectangle(SheetLayer::data, box);
    const Vec2 label(x + kFieldInset, box.hi.y() - kFieldInset / 2 - kSmall);
    sheet.text(SheetLayer::data, label, cell.label, kSmall);
    const SheetBox text = room(box, cell);
    draw_words(sheet, SheetLayer::data, text, cell.words, largest);
    if (cell.edge) {
      const Vec2 corner(x + kFieldInset, box.lo.y() + kFieldInset / 2);
      draw_edge(sheet, corner, {text.hi.x() - corner.x(), text.hi.y() - corner.y()});
    }
    x = box.hi.x();
  }
}

// Draws the symbol of first-angle projection (ISO 5456-2), which is a truncated cone and its view
// from the left.
void first_angle(Sheet& sheet, const Vec2& middle) {
  constexpr double kHeight = 4, kSmallEnd = 2, kLength = 4, kApart = 3;  // mm
  const auto line = [&](const Vec2& a, const Vec2& b) {
    sheet.line(SheetLayer::data, middle + a, middle + b);
  };
  const double left = -kApart / 2 - kLength, right = -kApart / 2;
  const Vec2 views[] = {
      {left, kSmallEnd / 2}, {right, kHeight / 2}, {right, -kHeight / 2}, {left, -kSmallEnd / 2}};
  for (std::size_t i = 0; i < 4; ++i) line(views[i], views[(i + 1) % 4]);
  const Vec2 centre(kApart / 2 + kHeight / 2, 0);
  for (const double diameter : {kSmallEnd, kHeight})
    sheet.circle(SheetLayer::data, middle + centre, diameter / 2);
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
  const DrawingInput& w = block.part.words;
  const double x = within.hi.x() - kWidth;
  double y = within.lo.y();
  const auto row = [&](double least, const std::vector<Cell>& cells, double largest) {
    const double height = height_for(cells, least, largest);
    draw_row(sheet, {x, y}, height, cells, largest);
    y += height;
  };
  row(kFieldRow,
      {{25, "Scale", block.scale},
       {45, "Dimensions in", fmt::format("{}, angles in degrees", to_string(block.part.units))},
       {25, "Projection", ""},
       {40, "Datum A", block.datum},
       {22, "Format", block.format},
       {23, "Sheet", block.part.number}},
      kUsual);
  first_angle(sheet, {x + 84, within.lo.y() + 3.4});
  row(kTitle, {{125, "Title", w.title}, {55, "Drawing number", w.number}}, kLarge);
  row(kFieldRow,
      {{75, "Material", w.material},
       {25, "Mass", block.part.mass},
       {45, "Author", w.author},
       {35, "Date", w.date}},
      kUsual);
  row(kFieldRow,
      {{60, "Heat treatment", w.heat_treatment},
       {45, "Surface texture", w.surface_texture},
       {35, "Edges, ISO 13715", with_minus(w.edges), true},
       {40, "General tolerances", w.general_tolerances}},
      kUsual);
  if (!w.note.empty()) row(kFieldRow, {{kWidth, "Note", w.note}}, kUsual);
  const SheetBox all{{x, within.lo.y()}, {within.hi.x(), y}};
  sheet.rectangle(SheetLayer::frame, all);
  return all;
}

Vec2 data_size(const std::vector<DataGroup>& groups, int columns) {
  double longest = 0.0;
  for (const auto& column : split(groups, columns)) {
    double rows = 0.0;
    for (const DataGroup* g : column) rows += rows_of(*g);
    longest = std::max(longest, rows);
  }
  return {columns * kColumn + (columns - 1) * kBetween, longest * kRow};
}

void draw_data(Sheet& sheet, const Vec2& corner, const std::vector<DataGroup>& groups,
               int columns) {
  double x = corner.x();
  for (const auto& column : split(groups, columns)) {
    double y = corner.y();
    for (const DataGroup* g : column) draw_group(sheet, x, y, *g);
    if (!column.empty()) sheet.rectangle(SheetLayer::frame, {{x, y}, {x + kColumn, corner.y()}});
    x += kColumn + kBetween;
  }
}

}  // namespace gearwright
