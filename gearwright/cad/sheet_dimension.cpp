#include <algorithm>
#include <cmath>

#include "gearwright/cad/sheet_font.hpp"
#include "gearwright/cad/sheet_parts.hpp"

namespace gearwright {

namespace {

// mm: extension lines start off the edge and pass the dimension line; words stand off their line;
// arrows from outside have a tail.
constexpr double kOff = 1, kPast = 1.5, kOverLine = 1.3, kTail = 6;
constexpr double kInside = 10;  // between two arrows that point outward
constexpr double kHatch = 2.5;

}  // namespace

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
  const double width = text_width(d.words, kUsual), length = d.end - d.begin;
  const bool inside = length >= std::max(kInside, width + 2);
  const Vec2 forward = at(1, 0);
  sheet.arrow(kLayer, at(d.begin, d.line), inside ? Vec2(-forward) : forward);
  sheet.arrow(kLayer, at(d.end, d.line), inside ? forward : Vec2(-forward));
  // Upright words stand to the left of their line, which is above it for who reads them.
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
    sheet.line(kLayer, at(d.begin - kTail - width, d.line), at(d.end + kTail, d.line));
    words(d.begin - kTail, Along::end);
  } else {
    sheet.line(kLayer, at(d.begin - kTail, d.line), at(d.end + kTail + width, d.line));
    words(d.end + kTail, Along::start);
  }
}

void hatch(Sheet& sheet, const SheetBox& box) {
  // Lines y = x + c; c in steps that do not depend on the box, so that parts of one body agree.
  const double step = kHatch * std::sqrt(2.0);
  const double least = box.lo.y() - box.hi.x(), most = box.hi.y() - box.lo.x();
  for (double n = std::ceil(least / step); n * step < most; ++n) {
    const double c = n * step;
    const double begin = std::max(box.lo.x(), box.lo.y() - c);
    const double end = std::min(box.hi.x(), box.hi.y() - c);
    if (begin < end) sheet.line(SheetLayer::hatch, {begin, begin + c}, {end, end + c});
  }
}

}  // namespace gearwright
