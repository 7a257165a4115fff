#include <algorithm>
#include <cmath>
#include <limits>

#include "gearwright/cad/sheet_font.hpp"
#include "gearwright/cad/sheet_parts.hpp"

namespace gearwright {

namespace {

// mm: a row, and its columns of words, symbol and value; between two columns of the table.
constexpr double kRow = 4.8, kWords = 41, kSymbol = 11, kValue = 36, kBetween = 4;
constexpr double kColumn = kWords + kSymbol + kValue;
constexpr double kInset = 1.2, kBase = 1.4;  // of words from the left, of the base line from below

double rows_of(const DataGroup& group) { return 1.0 + static_cast<double>(group.rows.size()); }

// The groups that begin a column: the split whose longest column is the shortest.
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

// In one line, smaller if it is too long.
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

}  // namespace

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
