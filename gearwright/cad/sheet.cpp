#include "gearwright/cad/sheet.hpp"

#include <array>

#include "gearwright/cad/sheet_font.hpp"
#include "gearwright/figure/symbol_pieces.hpp"

namespace gearwright {

namespace {

constexpr double kArrow = 2.5;      // mm, length
constexpr double kArrowHalf = 0.4;  // mm, half width
// Size of a subscript relative to the text, and the offsets of its base line.
constexpr double kIndex = 0.7, kBelow = 0.3, kAbove = 0.45;

using Place = SymbolPiece::Place;

double size_of(const SymbolPiece& piece, double height) {
  return piece.place == Place::base ? height : kIndex * height;
}

double shift_of(Along along, double width) {
  return along == Along::start ? 0.0 : along == Along::middle ? width / 2 : width;
}

}  // namespace

const LayerStyle& style_of(SheetLayer layer) {
  static constexpr std::array<LayerStyle, kSheetLayers> kStyles{{{"OUTLINE", 0.5, false, 7},
                                                                 {"HATCH", 0.18, false, 8},
                                                                 {"AXIS", 0.25, true, 1},
                                                                 {"DIMENSION", 0.25, false, 3},
                                                                 {"DATA", 0.25, false, 7},
                                                                 {"FRAME", 0.5, false, 7}}};
  return kStyles[static_cast<std::size_t>(layer)];
}

void Sheet::line(SheetLayer layer, const Vec2& a, const Vec2& b) {
  paths.push_back({layer, {a, b}, {0.0}});
}

void Sheet::rectangle(SheetLayer layer, const SheetBox& box) {
  paths.push_back({layer,
                   {box.lo, {box.hi.x(), box.lo.y()}, box.hi, {box.lo.x(), box.hi.y()}},
                   {0.0, 0.0, 0.0, 0.0},
                   true});
}

void Sheet::circle(SheetLayer layer, const Vec2& center, double radius) {
  circles.push_back({layer, center, radius});
}

void Sheet::arrow(SheetLayer layer, const Vec2& tip, const Vec2& direction) {
  const Vec2 along = direction.normalized(), across(-along.y(), along.x());
  const Vec2 back = tip - kArrow * along;
  paths.push_back({layer,
                   {tip, back + kArrowHalf * across, back - kArrowHalf * across},
                   {0.0, 0.0, 0.0},
                   true,
                   true});
}

void Sheet::text(SheetLayer layer, const Vec2& at, std::string_view words, double height,
                 Along along) {
  const double shift = shift_of(along, text_width(words, height));
  texts.push_back({layer, {at.x() - shift, at.y()}, std::string(words), height});
}

void Sheet::upright_text(SheetLayer layer, const Vec2& at, std::string_view words, double height,
                         Along along) {
  const double shift = shift_of(along, text_width(words, height));
  texts.push_back({layer, {at.x(), at.y() - shift}, std::string(words), height, true});
}

void Sheet::symbol(SheetLayer layer, const Vec2& at, std::string_view symbol, double height) {
  double x = at.x();
  for (const SymbolPiece& piece : symbol_pieces(symbol)) {
    if (piece.text.empty()) continue;
    const double size = size_of(piece, height);
    const double y = piece.place == Place::below   ? -kBelow * height
                     : piece.place == Place::above ? kAbove * height
                                                   : 0.0;
    texts.push_back({layer, {x, at.y() + y}, piece.text, size});
    x += text_width(piece.text, size);
  }
}

double symbol_width(std::string_view symbol, double height) {
  double width = 0.0;
  for (const SymbolPiece& piece : symbol_pieces(symbol))
    width += text_width(piece.text, size_of(piece, height));
  return width;
}

SheetBox box_of(const SheetText& text) {
  const double width = text_width(text.text, text.height);
  const double below = kDescent * text.height;
  if (text.upright)
    return {{text.at.x() - text.height, text.at.y()}, {text.at.x() + below, text.at.y() + width}};
  return {{text.at.x(), text.at.y() - below}, {text.at.x() + width, text.at.y() + text.height}};
}

}  // namespace gearwright
