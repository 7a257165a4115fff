#include "gearwright/cad/svg_outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <string_view>

#include "gearwright/base/contract.hpp"
#include "gearwright/cad/bezier.hpp"
#include "gearwright/cad/contour.hpp"

namespace gearwright {
namespace {

constexpr double kMargin = 0.05;  // of the radius, so that the stroke is not cut off

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      default: result += c;
    }
  }
  return result;
}

// The d attribute; y is turned over here and nowhere else.
class Path {
 public:
  void move(const Vec2& p) { add("M{} {}", p.x(), -p.y()); }
  void line(const Vec2& p) { add("L{} {}", p.x(), -p.y()); }
  // A counter-clockwise arc is one on the screen too: sweep flag 0.
  void arc(double radius, double sweep, const Vec2& p) {
    add("A{0} {0} 0 {1} 0 {2} {3}", radius, sweep > std::numbers::pi ? 1 : 0, p.x(), -p.y());
  }
  void cubic(const Vec2& a, const Vec2& b, const Vec2& c) {
    add("C{} {} {} {} {} {}", a.x(), -a.y(), b.x(), -b.y(), c.x(), -c.y());
  }
  void close() { text_ += "Z\n"; }
  const std::string& text() const { return text_; }

 private:
  // Ten decimals without the zeros at the end: 1e-10 mm.
  static std::string shorter(double value) {
    std::string text = fmt::format("{:.10f}", value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
  }
  static int shorter(int value) { return value; }
  template <class... T>
  void add(const char* form, T... values) {
    fmt::format_to(std::back_inserter(text_), fmt::runtime(form), shorter(values)...);
    text_ += '\n';
  }

  std::string text_;
};

}  // namespace

Result<Drawing> svg_drawing(const ToothedBody& body, const SvgOptions& options) {
  GW_EXPECTS(options.tolerance_mm > 0.0);
  const auto contour = closed_contour(body.outline);
  if (!contour) return contour.error();
  const auto bore = bore_contour(body, contour->inner_radius, contour->outer_radius);
  if (!bore) return bore.error();

  int segments = 0;
  double deviation = 0.0;
  std::vector<std::optional<BezierChain>> chains(body.outline.arcs.size());
  Path path;
  path.move(contour->pieces.front().begin);
  for (const ContourPiece& piece : contour->pieces) {
    if (piece.land) {
      path.arc(piece.begin.norm(), piece.sweep, piece.end);
      ++segments;
      continue;
    }
    std::optional<BezierChain>& chain = chains[piece.arc];
    if (!chain) {
      const Arc& arc = body.outline.arcs[piece.arc];
      chain = fit_beziers(arc, options.tolerance_mm);
      if (!(chain->deviation_mm <= options.tolerance_mm)) {
        return beyond_tolerance(arc, chain->deviation_mm, options.tolerance_mm);
      }
      deviation = std::max(deviation, chain->deviation_mm);
    }
    const std::vector<Vec2> p = placed(*contour, piece, chain->points);
    for (std::size_t i = 1; i < p.size(); i += 3) path.cubic(p[i], p[i + 1], p[i + 2]);
    segments += static_cast<int>(p.size() / 3);
  }
  path.close();

  double reach = contour->outer_radius;
  if (const auto& b = *bore) {
    path.move(b->points.front());
    for (std::size_t i = 0; i < b->points.size(); ++i) {
      const Vec2& to = b->points[(i + 1) % b->points.size()];
      if (b->bulges[i] == 0.0) {
        path.line(to);
      } else {
        path.arc(b->radius, 4.0 * std::atan(b->bulges[i]), to);
      }
    }
    path.close();
    segments += static_cast<int>(b->points.size());
    reach = std::max(reach, b->radius);
  }

  const double half = (1.0 + kMargin) * reach;
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.6f}mm\" height=\"{0:.6f}mm\" "
      "viewBox=\"{1:.6f} {1:.6f} {0:.6f} {0:.6f}\">\n"
      "<title>{2}</title>\n"
      "<path fill=\"#dfe3e8\" fill-rule=\"evenodd\" stroke=\"#1b2733\" stroke-width=\"{3:.4f}\" "
      "stroke-linejoin=\"round\" d=\"\n{4}\"/>\n"
      "</svg>\n",
      2.0 * half, -half, escaped(body.name), 0.002 * half, path.text());
  return Drawing{std::move(text), segments, deviation, options.tolerance_mm};
}

}  // namespace gearwright
