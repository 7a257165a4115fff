#include "gearwright/cad/sheet_parts.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/cad/sheet_symbols.hpp"

namespace gearwright {

namespace {

// Lengths in mm. An extension line begins kOff from the edge and ends kPast beyond the dimension
// line. A text is kOverLine from its line. The line behind an outside arrow has the length kTail.
constexpr double kOff = 1, kPast = 1.5, kOverLine = 1.3, kTail = 6;
constexpr double kInside = 10;  // least distance between the edges for arrows inside the extension
                                // lines
constexpr double kHatch = 2.5;

constexpr double kLine = 1.5;  // distance between lines of text, relative to the height of capitals

// Breaks text into lines at spaces and line breaks. A single word may be longer than `width`.
std::vector<std::string> broken(std::string_view words, double height, double width) {
  std::vector<std::string> lines;
  bool new_line = true;
  while (!words.empty()) {
    const std::size_t end = std::min(words.find_first_of(" \n\t"), words.size());
    const std::string word(words.substr(0, end));
    if (!word.empty()) {
      new_line = new_line || text_width(lines.back() + " " + word, height) > width;
      if (new_line)
        lines.push_back(word);
      else
        lines.back() += " " + word;
      new_line = false;
    }
    new_line = new_line || (end < words.size() && words[end] == '\n');
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return lines;
}

std::string cut(std::string text, double height, double width) {
  constexpr std::string_view kMore = "…";
  while (!text.empty() && text_width(text + std::string(kMore), height) > width) {
    std::size_t last = text.size() - 1;
    while (last > 0 && !begins_character(text[last])) --last;
    text.erase(last);
  }
  return text + std::string(kMore);
}

struct Lines {
  std::vector<std::string> lines;
  double height;  // h  mm
  bool whole;     // true if the lines fit
};

Lines laid_out(const Vec2& size, std::string_view words, double largest) {
  Lines all{{}, kSmall, false};
  for (const double h : {kLarge, kUsual, kSmall}) {
    if (h > largest) continue;
    all = {broken(words, h, size.x()), h, false};
    const double more = static_cast<double>(all.lines.size()) - 1;
    const auto fits = [&](const std::string& line) { return text_width(line, h) <= size.x(); };
    all.whole = (kLine * more + 1 + kDescent) * h <= size.y() &&
                std::all_of(all.lines.begin(), all.lines.end(), fits);
    if (all.whole) break;
  }
  return all;
}

}  // namespace

bool has_room(const Dimension& d) {
  return d.end - d.begin >= std::max(kInside, text_width(d.words, kUsual) + 2);
}

Reach reach_of(const Dimension& d) {
  const double datum = d.datum ? kDatumHeight : kPast;
  if (has_room(d)) return {d.begin - datum, d.end + kPast};
  return {d.begin - kTail - text_width(d.words, kUsual), d.end + std::max(kTail, datum)};
}

void draw_dimension(Sheet& sheet, const Dimension& d) {
  const bool up = d.direction == Direction::up;
  const auto at = [up](double along, double across) {
    return up ? Vec2(across, along) : Vec2(along, across);
  };
  constexpr auto kLayer = SheetLayer::dimension;
  const auto extension = [&](double along, double edge) {
    const double side = d.line > edge ? 1.0 : -1.0;
    sheet.line(kLayer, at(along, edge + kOff * side), at(along, d.line + kPast * side));
  };
  extension(d.begin, d.edge_begin);
  extension(d.end, d.edge_end);
  GW_EXPECTS(up || !d.datum);
  const double width = text_width(d.words, kUsual);
  const bool inside = has_room(d);
  const Vec2 forward = at(1, 0);
  // If there is no room between the edges, the datum replaces the arrow at the upper end.
  const bool replaced = d.datum && !inside;
  sheet.arrow(kLayer, at(d.begin, d.line), inside ? Vec2(-forward) : forward);
  if (!replaced) sheet.arrow(kLayer, at(d.end, d.line), inside ? forward : Vec2(-forward));
  if (d.datum) {
    if (inside)
      draw_datum(sheet, at(d.begin, d.line), DatumSide::below);
    else
      draw_datum(sheet, at(d.end, d.line), DatumSide::above);
  }
  // Upright text is to the left of its dimension line. A reader at the right-hand side of the sheet
  // then sees the text above the line.
  const double base = up ? d.line - kOverLine : d.line + kOverLine;
  const auto words = [&](double along, Along where) {
    if (up)
      sheet.upright_text(kLayer, at(along, base), d.words, kUsual, where);
    else
      sheet.text(kLayer, at(along, base), d.words, kUsual, where);
  };
  if (inside) {
    sheet.line(kLayer, at(d.begin, d.line), at(d.end, d.line));
    words((d.begin + d.end) / 2, Along::middle);
  } else if (up) {
    const double top = replaced ? 0.0 : kTail;
    sheet.line(kLayer, at(d.begin - kTail - width, d.line), at(d.end + top, d.line));
    words(d.begin - kTail, Along::end);
  } else {
    sheet.line(kLayer, at(d.begin - kTail, d.line), at(d.end + kTail + width, d.line));
    words(d.end + kTail, Along::start);
  }
}

void hatch(Sheet& sheet, const SheetBox& box) {
  // Hatching lines are y = x + c. The values of c do not depend on the box, so the lines of all
  // hatched parts of a body are aligned.
  const double step = kHatch * std::sqrt(2.0);
  const double least = box.lo.y() - box.hi.x(), most = box.hi.y() - box.lo.x();
  for (double n = std::ceil(least / step); n * step < most; ++n) {
    const double c = n * step;
    const double begin = std::max(box.lo.x(), box.lo.y() - c);
    const double end = std::min(box.hi.x(), box.hi.y() - c);
    if (begin < end) sheet.line(SheetLayer::hatch, {begin, begin + c}, {end, end + c});
  }
}

bool words_fit(const Vec2& size, std::string_view words, double largest) {
  return laid_out(size, words, largest).whole;
}

void draw_words(Sheet& sheet, SheetLayer layer, const SheetBox& box, std::string_view words,
                double largest) {
  const Vec2 size = box.hi - box.lo;
  const auto [lines, height, whole] = laid_out(size, words, largest);
  double y = box.hi.y() - height;
  for (std::size_t i = 0; i < lines.size(); ++i, y -= kLine * height) {
    const bool more = i + 1 < lines.size();
    const bool last = y - (kLine + kDescent) * height < box.lo.y();
    std::string line = lines[i];
    if ((more && last) || text_width(line, height) > size.x()) line = cut(line, height, size.x());
    sheet.text(layer, {box.lo.x(), y}, line, height);
    if (last) break;
  }
}

}  // namespace gearwright
