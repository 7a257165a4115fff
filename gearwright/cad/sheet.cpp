#include "gearwright/cad/sheet.hpp"

#include <algorithm>
#include <array>

#include "gearwright/base/printable.hpp"
#include "gearwright/figure/markup.hpp"

namespace gearwright {

namespace {

constexpr double kArrow = 2.5;      // mm, length of an arrow head
constexpr double kArrowHalf = 0.4;  // mm, half of the width of an arrow head
// Size of a subscript or superscript relative to the text, and offsets of their base lines.
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

namespace {

// Widths of the letters of Helvetica, in thousandths of the font size, by their WinAnsi codes from
// 32 on. Codes without a letter have the width of the bullet.
constexpr std::array<short, 224> kHelvetica{
    278,  278, 355, 556, 556, 889,  667,  191,  333, 333,  389, 584, 278,  333, 278, 278,  //
    556,  556, 556, 556, 556, 556,  556,  556,  556, 556,  278, 278, 584,  584, 584, 556,  //
    1015, 667, 667, 722, 722, 667,  611,  778,  722, 278,  500, 667, 556,  833, 722, 778,  //
    667,  778, 722, 667, 611, 722,  667,  944,  667, 667,  611, 278, 278,  278, 469, 556,  //
    333,  556, 556, 500, 556, 556,  278,  556,  556, 222,  222, 500, 222,  833, 556, 556,  //
    556,  556, 333, 500, 278, 556,  500,  722,  500, 500,  500, 334, 260,  334, 584, 350,  //
    556,  350, 222, 556, 333, 1000, 556,  556,  333, 1000, 667, 333, 1000, 350, 611, 350,  //
    350,  222, 222, 333, 333, 350,  556,  1000, 333, 1000, 500, 333, 944,  350, 500, 667,  //
    278,  333, 556, 556, 556, 556,  260,  556,  333, 737,  370, 556, 584,  333, 737, 333,  //
    400,  584, 333, 333, 333, 556,  537,  278,  333, 333,  365, 556, 834,  834, 834, 611,  //
    667,  667, 667, 667, 667, 667,  1000, 722,  667, 667,  667, 667, 278,  278, 278, 278,  //
    722,  722, 778, 778, 778, 778,  778,  584,  778, 722,  722, 722, 722,  667, 667, 611,  //
    556,  556, 556, 556, 556, 556,  889,  500,  556, 556,  556, 556, 278,  278, 278, 278,  //
    556,  556, 556, 556, 556, 556,  556,  584,  611, 556,  556, 556, 556,  500, 556, 500};

// The characters at the WinAnsi codes 0x80 to 0x9F; 0 if there is none.
constexpr std::array<char32_t, 32> kWindows{
    0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0,      0x017D, 0,      0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};

// The codes in the font Symbol of the code points from Α to ω. A code is 0 if the code point is not
// assigned in Unicode, or if its letter has an accent or a dieresis, which the font does not have.
constexpr char32_t kAlpha = 0x0391, kLastGreek = 0x03C9;
constexpr std::string_view kGreek{
    "ABGDEZHQIKLMNXOPR\0STUFCYW\0\0\0\0\0\0\0abgdezhqiklmnxoprVstufcyw", 57};
static_assert(kGreek.size() == kLastGreek - kAlpha + 1);

struct Sign {
  char32_t code;
  unsigned char symbol;
};
// The Unicode code point and the code in the font Symbol of each sign, in the order minus, minute,
// second, ≤, ≥, ≈, ≠, ∞, √, →.
constexpr std::array<Sign, 10> kSigns{{{0x2212, 0x2D},
                                       {0x2032, 0xA2},
                                       {0x2033, 0xB2},
                                       {0x2264, 0xA3},
                                       {0x2265, 0xB3},
                                       {0x2248, 0xBB},
                                       {0x2260, 0xB9},
                                       {0x221E, 0xA5},
                                       {0x221A, 0xD6},
                                       {0x2192, 0xAE}}};

// Widths of the letters of the font Symbol, by their codes from A to z. kSignWidths contains the
// widths of kSigns, in the same order.
constexpr std::array<short, 58> kSymbolLetters{
    722, 667, 722, 612, 611, 763, 603, 722, 333, 631, 722, 686, 889, 722, 722,  //
    768, 741, 556, 592, 611, 690, 439, 768, 645, 795, 611, 333, 863, 333, 658,  //
    500, 500, 631, 549, 549, 494, 439, 521, 411, 603, 329, 603, 549, 549, 576,  //
    521, 549, 549, 521, 549, 603, 439, 576, 713, 686, 493, 686, 494};
constexpr std::array<short, 10> kSignWidths{549, 247, 411, 549, 549, 549, 549, 713, 549, 987};

SheetLetter helvetica(std::size_t code, bool known = true) {
  return {SheetFont::helvetica, static_cast<unsigned char>(code), kHelvetica[code - 32], known};
}

}  // namespace

SheetLetter letter_of(char32_t code) {
  if ((code >= 0x20 && code < 0x7F) || (code >= 0xA0 && code <= 0xFF)) return helvetica(code);
  const auto* const windows = std::find(kWindows.begin(), kWindows.end(), code);
  if (code != 0 && windows != kWindows.end())
    return helvetica(0x80 + static_cast<std::size_t>(windows - kWindows.begin()));
  if (code >= kAlpha && code <= kLastGreek) {
    const auto letter = static_cast<unsigned char>(kGreek[code - kAlpha]);
    if (letter != 0) return {SheetFont::symbol, letter, kSymbolLetters[letter - 'A'], true};
  }
  for (std::size_t i = 0; i < kSigns.size(); ++i) {
    if (kSigns[i].code == code) return {SheetFont::symbol, kSigns[i].symbol, kSignWidths[i], true};
  }
  return helvetica('?', false);
}

double text_width(std::string_view text, double height) {
  int thousandths = 0;
  for (const char32_t code : code_points(text)) thousandths += letter_of(code).width;
  return thousandths / 1000.0 * height / kCapital;
}

}  // namespace gearwright
