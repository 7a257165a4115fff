#include "docs/figures/figure.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "gearwright/base/contract.hpp"
#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/figure/gear_shape.hpp"
#include "gearwright/report/html_text.hpp"

namespace gearwright::figures {

namespace {

// The classes of the shapes that are drawn here, in addition to figure_style.css.
constexpr std::string_view kShapes = R"(
.d path,.d circle,.d polyline,.d polygon,.d rect{stroke-width:1.2}
.d text{font-size:14px}.d text.small{font-size:12px}.d text.bold{font-weight:650}
.d .thin{stroke-width:.8}.d .thick{stroke-width:2.2}.d .heavy{stroke-width:3}
.d .ink{stroke:var(--ink)}.d .soft{stroke:var(--soft)}.d .rule{stroke:var(--rule)}.d .grey{stroke:var(--grey-ink)}
.d .g1{stroke:var(--g1)}.d .g2{stroke:var(--g2)}.d .action{stroke:var(--action)}.d .green{stroke:var(--trailing)}
.d .paper{fill:var(--panel)}.d .body1{fill:var(--g1-fill)}.d .body2{fill:var(--g2-fill)}
.fill-ink{fill:var(--ink)}.fill-soft{fill:var(--soft)}.fill-g1{fill:var(--g1)}.fill-g2{fill:var(--g2)}
.fill-action{fill:var(--action)}.fill-green{fill:var(--trailing)}
text.soft{fill:var(--soft)}text.action{fill:var(--action)}text.green{fill:var(--trailing)}
.d text[class]{stroke:none}.d text.halo{stroke:var(--panel)}
)";

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
    : name_(name), svg_("figure", width, height, title, description) {
  svg_.begin_group("class=\"d\"");
  svg_.rect(0, 0, width, height, "paper");
}

std::string Drawing::str() const {
  Svg svg = svg_;
  svg.end_group();
  std::string text = svg.str();
  text.insert(text.rfind("</svg>"), figures_);
  for (const std::string_view of_pages : {" class=\"zoom\"", " tabindex=\"0\""})
    replace(text, of_pages, "");
  text.insert(text.find(' '), " xmlns=\"http://www.w3.org/2000/svg\"");
  text.insert(text.find("</desc>\n") + 8,
              fmt::format("<style>\n{}{}</style>\n", figure_style(), kShapes));
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

void Drawing::label(const Vec2& at, std::string_view words, Anchor anchor, const Vec2& offset,
                    std::string_view style) {
  svg_.text(at, markup(words), anchor, style, offset);
}

void Drawing::head(const Vec2& tip, const Vec2& direction, std::string_view style) {
  const Vec2 d = direction.normalized();
  const Vec2 across(-d.y(), d.x());
  const std::string_view colour = style.substr(0, style.find(' '));
  svg_.polygon({tip, tip - 9.0 * d + 3.4 * across, tip - 9.0 * d - 3.4 * across},
               fmt::format("fill-{}", colour));
}

void Drawing::arrow(const Vec2& from, const Vec2& to, std::string_view style, bool both) {
  svg_.line(from, to, style);
  head(to, to - from, style);
  if (both) head(from, from - to, style);
}

void Drawing::arc(const Viewport& view, const Vec2& center, double radius, double from, double to,
                  std::string_view style, int heads) {
  const int n = std::max(2, static_cast<int>(std::ceil(std::abs(to - from) * 30.0)));
  std::vector<Vec2> points;
  for (int i = 0; i <= n; ++i)
    points.push_back(view.px(center + polar(radius, from + (to - from) * i / n)));
  svg_.polyline(points, style);
  if (heads > 0) head(points.back(), points.back() - points[points.size() - 2], style);
  if (heads > 1) head(points.front(), points.front() - points[1], style);
}

void Drawing::circle(const Viewport& view, const Vec2& center, double radius,
                     std::string_view style) {
  svg_.circle(view.px(center), radius * view.scale, style);
}

void Drawing::line(const Viewport& view, const std::vector<Vec2>& mm, std::string_view style) {
  std::vector<Vec2> points;
  for (const Vec2& p : mm) points.push_back(view.px(p));
  svg_.polyline(points, style);
}

void Drawing::shape(const Viewport& view, const std::vector<Vec2>& mm, std::string_view style) {
  std::vector<Vec2> points;
  for (const Vec2& p : mm) points.push_back(view.px(p));
  svg_.polygon(points, style);
}

void Drawing::dot(const Viewport& view, const Vec2& mm, std::string_view style, double radius) {
  svg_.circle(view.px(mm), radius, style);
}

Vec2 polar(double radius, double angle) { return radius * Vec2(std::cos(angle), std::sin(angle)); }

std::vector<Vec2> placed(std::vector<Vec2> points, double angle, const Vec2& shift) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  for (Vec2& p : points) p = Vec2(c * p.x() - s * p.y(), s * p.x() + c * p.y()) + shift;
  return points;
}

std::vector<Vec2> half_tooth(const Gear& gear, double tolerance) {
  std::vector<Vec2> points;
  for (const Arc& arc : gear.tooth.value().outline.arcs) {
    const std::vector<Vec2> more = chords(arc, tolerance);
    points.insert(points.end(), more.begin() + (points.empty() ? 0 : 1), more.end());
  }
  return points;
}

std::vector<Vec2> teeth(const Gear& gear, int first, int last, double angle, double tolerance) {
  const std::vector<Vec2> half = half_tooth(gear, tolerance);
  std::vector<Vec2> tooth;  // counter-clockwise: out along the side y < 0, then in along the other
  for (const Vec2& p : half) tooth.push_back({p.x(), -p.y()});
  for (auto p = half.rbegin(); p != half.rend(); ++p) tooth.push_back(*p);
  std::vector<Vec2> all;
  const double pitch = 2.0 * std::numbers::pi / std::abs(gear.spec.teeth);
  for (int k = first; k <= last; ++k) {
    const auto one = placed(tooth, angle + k * pitch, Vec2::Zero());
    all.insert(all.end(), one.begin() + (all.empty() ? 0 : 1), one.end());
  }
  return all;
}

Gear gear_of(const CylindricalSpec& spec) { return make_gear(spec).value(); }

}  // namespace gearwright::figures
