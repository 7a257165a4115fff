#include "gearwright/cad/sheet_symbols.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/cad/sheet_parts.hpp"

namespace gearwright {

namespace {

constexpr auto kThin = SheetLayer::dimension;

// Lengths in mm for h = 2.5 mm. The legs of the symbol of surface texture have the heights kShort
// and kTextureHeight. A missing text has the width kBlank. A text is kNear from a line.
constexpr double kShort = 3.5, kBlank = 9, kNear = 0.6;
// Side of the datum's triangle, and distance from its base to the box.
constexpr double kTriangle = 3, kStem = kDatumHeight - kFrameHeight;
const double kTan60 = std::sqrt(3.0);

struct Texture {
  bool bar, circle;
  std::string_view words;  // without the word that selects the symbol
};

Texture texture_of(std::string_view words) {
  const auto begins = [words](std::string_view first) {
    return words.starts_with(first) && (words.size() == first.size() || words[first.size()] == ' ');
  };
  Texture texture{begins("MRR"), begins("NMR"), words};
  if (texture.bar || texture.circle || begins("APA")) texture.words.remove_prefix(3);
  texture.words.remove_prefix(std::min(texture.words.find_first_not_of(' '), texture.words.size()));
  return texture;
}

double text_or_blank(std::string_view words) {
  return words.empty() ? kBlank : text_width(words, kUsual);
}

}  // namespace

double texture_left() { return kShort / kTan60; }

double texture_right(std::string_view words) {
  return kTextureHeight / kTan60 + 2 * kNear + text_or_blank(texture_of(words).words);
}

void draw_texture(Sheet& sheet, const Vec2& foot, std::string_view words) {
  const Texture texture = texture_of(words);
  const Vec2 left(-texture_left(), kShort), right(kTextureHeight / kTan60, kTextureHeight);
  sheet.line(kThin, foot, foot + left);
  sheet.line(kThin, foot, foot + right);
  sheet.line(kThin, foot + right, foot + Vec2(texture_right(words), kTextureHeight));
  if (texture.bar) sheet.line(kThin, foot + left, foot + Vec2(-left.x(), kShort));
  // The circle touches both legs and the horizontal through the upper end of the shorter leg.
  if (texture.circle) sheet.circle(kThin, foot + Vec2(0, kShort * 2 / 3), kShort / 3);
  if (!texture.words.empty())
    sheet.text(kThin, foot + right + Vec2(kNear, -kUsual - 1), texture.words, kUsual);
}

double runout_width(std::string_view value) {
  return 2 * kFrameHeight + std::max(kBlank, text_or_blank(value) + 4 * kNear);
}

void draw_runout(Sheet& sheet, const Vec2& lo, double width, std::string_view value) {
  constexpr double kRounding = 1e-9;  // mm
  GW_EXPECTS(width >= runout_width(value) - kRounding);
  const Vec2 hi = lo + Vec2(width, kFrameHeight);
  sheet.rectangle(kThin, {lo, hi});
  const double first = lo.x() + kFrameHeight, last = hi.x() - kFrameHeight;
  for (const double x : {first, last}) sheet.line(kThin, {x, lo.y()}, {x, hi.y()});
  const Vec2 tip = lo + Vec2(4.2, 4.2);
  sheet.line(kThin, lo + Vec2(0.8, 0.8), tip);
  sheet.arrow(kThin, tip, Vec2(1, 1));
  const double base = lo.y() + (kFrameHeight - kUsual) / 2;
  if (!value.empty()) sheet.text(kThin, {(first + last) / 2, base}, value, kUsual, Along::middle);
  sheet.text(kThin, {last + kFrameHeight / 2, base}, kDatum, kUsual, Along::middle);
}

void draw_datum(Sheet& sheet, const Vec2& at, DatumSide side) {
  const double up = side == DatumSide::above ? 1.0 : -1.0;
  const Vec2 half(kTriangle / 2, 0), tip = at + Vec2(0, up * kTriangle * kTan60 / 2);
  sheet.paths.push_back({kThin, {at - half, at + half, tip}, {0.0, 0.0, 0.0}, true, true});
  sheet.line(kThin, tip, at + Vec2(0, up * kStem));
  const Vec2 middle = at + Vec2(0, up * (kStem + kDatumHalf)), corner(kDatumHalf, kDatumHalf);
  sheet.rectangle(kThin, {middle - corner, middle + corner});
  sheet.text(kThin, middle - Vec2(0, kUsual / 2), kDatum, kUsual, Along::middle);
}

void draw_edge(Sheet& sheet, const Vec2& corner, const Vec2& lengths) {
  sheet.line(kThin, corner, corner + Vec2(lengths.x(), 0));
  sheet.line(kThin, corner, corner + Vec2(0, lengths.y()));
}

}  // namespace gearwright
