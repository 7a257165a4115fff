#include "docs/figures/figure.hpp"

#include <fmt/format.h>

#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/figure/gear_shape.hpp"
#include "gearwright/report/html_text.hpp"

namespace gearwright::figures {

namespace {

void replace(std::string& text, std::string_view what, std::string_view by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; at += by.size())
    text.replace(at, what.size(), by);
}

}  // namespace

std::string markup(std::string_view words) {
  std::string result;
  while (!words.empty()) {
    const std::size_t open = words.find('{');
    result += escaped(words.substr(0, open));
    if (open == std::string_view::npos) break;
    const std::size_t close = words.find('}', open);
    GW_EXPECTS(close != std::string_view::npos);
    result += symbol_svg(words.substr(open + 1, close - open - 1));
    words.remove_prefix(close + 1);
  }
  return result;
}

Drawing::Drawing(std::string_view name, double width, double height, std::string_view title,
                 std::string_view description)
    : name_(name), svg_("figure", width, height, title, description) {}

Drawing::Drawing(const Figure& figure, double width)
    : Drawing(figure.id, width, figure.tall * width, figure.title, figure.description) {
  add(figure, Vec2::Zero(), width);
}

std::string Drawing::str() const {
  std::string text = svg_.str();
  text.insert(text.rfind("</svg>"), figures_);
  for (const std::string_view of_pages : {" class=\"zoom\"", " tabindex=\"0\""})
    replace(text, of_pages, "");
  text.insert(text.find(' '), " xmlns=\"http://www.w3.org/2000/svg\"");
  text.insert(text.find("</desc>\n") + 8,
              fmt::format("<style>\n{}svg{{background:var(--panel)}}</style>\n", figure_style()));
  return text;
}

void Drawing::add(const Figure& figure, const Vec2& corner, double width) {
  std::string text = figure_svg(figure, width);
  text.insert(text.find(' '),
              fmt::format(" x=\"{}\" y=\"{}\"", pixel(corner.x()), pixel(corner.y())));
  figures_ += text;
}

void name_decades(FigureAxis& axis) {
  for (double p = std::ceil(std::log10(axis.lo)); p <= std::log10(axis.hi); p += 2.0)
    axis.names.push_back({std::pow(10.0, p), p == 0.0 ? "1" : fmt::format("1e{}", p)});
}

Bounds window(const Vec2& middle, const Vec2& size, double scale) {
  const Vec2 half = size / (2 * scale);
  return {middle - half, middle + half};
}

void add_gear(Figure& figure, const Gear& gear, const std::string& name, const std::string& style,
              const Vec2& at, double angle) {
  if (figure.definitions.find('"' + name + '"') == std::string::npos)
    figure.definitions += gear_definition(gear, name);
  figure.marks.push_back({FigureMark::Kind::shape, style, {at}, name});
  figure.marks.back().radius = outline_unit_mm(gear);
  figure.marks.back().turned = kDegPerRad * angle;
}

void add_arrow(Figure& figure, std::vector<Vec2> points, const std::string& style, bool both) {
  if (both) add_arrow(figure, {points.rbegin(), points.rend()}, style);
  figure.line(std::move(points), style);
  figure.marks.back().head = true;
  for (const int gear : {0, 1})
    if (style.ends_with(kInk[static_cast<std::size_t>(gear)])) figure.marks.back().gear = gear;
}

std::vector<Vec2> arc_points(const Vec2& center, double radius, double from, double to) {
  const int n = std::max(2, static_cast<int>(std::ceil(std::abs(to - from) * 30.0)));
  std::vector<Vec2> points;
  for (int i = 0; i <= n; ++i) points.push_back(center + polar(radius, from + (to - from) * i / n));
  return points;
}

Vec2 polar(double radius, double angle) { return radius * Vec2(std::cos(angle), std::sin(angle)); }

std::vector<Vec2> placed(std::vector<Vec2> points, double angle, const Vec2& shift) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  for (Vec2& p : points) p = Vec2(c * p.x() - s * p.y(), s * p.x() + c * p.y()) + shift;
  return points;
}

Gear gear_of(const CylindricalSpec& spec) { return make_gear(spec).value(); }

}  // namespace gearwright::figures
