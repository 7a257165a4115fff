#include "docs/figures/figure.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/contract.hpp"
#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/figure/gear_shape.hpp"
#include "gearwright/figure/ticks.hpp"
#include "gearwright/report/html_text.hpp"

namespace gearwright::figures {

namespace {

// The colours of all figures, light and dark: the first rules of figure_style.css.
std::string_view palette() {
  const std::string_view style = figure_style();
  const std::size_t begin = style.find(":root{"), end = style.find("\n.key{");
  GW_EXPECTS(begin != style.npos && end != style.npos && begin < end);
  return style.substr(begin, end - begin);
}

constexpr std::string_view kRules = R"(
path,circle,polyline,polygon,rect{fill:none;stroke-width:1.2;stroke-linejoin:round}
text{font:14px system-ui,-apple-system,"Segoe UI",Roboto,"Noto Sans","DejaVu Sans",sans-serif;fill:var(--ink);stroke:none}
tspan.v{font-style:italic;font-family:"STIX Two Text",Cambria,"DejaVu Serif",serif}
tspan.s{font-size:10px}text.m,text.m tspan{text-anchor:middle}text.e{text-anchor:end}
text.small,text.tick{font-size:12px}text.bold{font-weight:650}
.thin{stroke-width:.8}.thick{stroke-width:2.2}.heavy{stroke-width:3}
.dash{stroke-dasharray:7 4}.dashdot{stroke-dasharray:12 4 2 4}.dot{stroke-dasharray:1.5 3}
.grid,.axis{stroke-width:1}
.ink{stroke:var(--ink)}.soft{stroke:var(--soft)}.rule{stroke:var(--rule)}.grey{stroke:var(--grey-ink)}
.g1{stroke:var(--g1)}.g2{stroke:var(--g2)}.action{stroke:var(--action)}.green{stroke:var(--trailing)}.yellow{stroke:var(--beta)}
.ground{fill:var(--paper)}.body1{fill:var(--g1-fill)}.body2{fill:var(--g2-fill)}.cutter{fill:var(--faint)}
.band{fill:var(--trailing);fill-opacity:.12}
.fill-ink{fill:var(--ink)}.fill-soft{fill:var(--soft)}.fill-g1{fill:var(--g1)}.fill-g2{fill:var(--g2)}
.fill-action{fill:var(--action)}.fill-green{fill:var(--trailing)}
text.soft{fill:var(--soft)}text.g1{fill:var(--g1)}text.g2{fill:var(--g2)}text.action{fill:var(--action)}text.green{fill:var(--trailing)}
text.soft,text.g1,text.g2,text.action,text.green{stroke:none}
text.halo{paint-order:stroke;stroke:var(--paper);stroke-width:4px;stroke-linejoin:round}
)";

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

Figure::Figure(std::string_view name, double width, double height, std::string_view title,
               std::string_view description)
    : name_(name), svg_("figure", width, height, title, description) {
  svg_.rect(0, 0, width, height, "ground");
}

std::string Figure::str() const {
  std::string text = svg_.str();
  const auto replace = [&](std::string_view what, std::string_view by) {
    const std::size_t at = text.find(what);
    GW_EXPECTS(at != std::string::npos);
    text.replace(at, what.size(), by);
  };
  replace("<svg class=\"zoom\" ", "<svg xmlns=\"http://www.w3.org/2000/svg\" ");
  replace(" tabindex=\"0\"", "");
  replace("</desc>\n",
          "</desc>\n<style>\n" + std::string(palette()) + std::string(kRules) + "</style>\n");
  return text;
}

void Figure::label(const Vec2& at, std::string_view words, Anchor anchor, const Vec2& offset,
                   std::string_view style) {
  svg_.text(at, markup(words), anchor, style, offset);
}

void Figure::head(const Vec2& tip, const Vec2& direction, std::string_view style) {
  const Vec2 d = direction.normalized();
  const Vec2 across(-d.y(), d.x());
  const std::string_view colour = style.substr(0, style.find(' '));
  svg_.polygon({tip, tip - 9.0 * d + 3.4 * across, tip - 9.0 * d - 3.4 * across},
               fmt::format("fill-{}", colour));
}

void Figure::arrow(const Vec2& from, const Vec2& to, std::string_view style, bool both) {
  svg_.line(from, to, style);
  head(to, to - from, style);
  if (both) head(from, from - to, style);
}

void Figure::arc(const Viewport& view, const Vec2& center, double radius, double from, double to,
                 std::string_view style, int heads) {
  const int n = std::max(2, static_cast<int>(std::ceil(std::abs(to - from) * 30.0)));
  std::vector<Vec2> points;
  for (int i = 0; i <= n; ++i)
    points.push_back(view.px(center + polar(radius, from + (to - from) * i / n)));
  svg_.polyline(points, style);
  if (heads > 0) head(points.back(), points.back() - points[points.size() - 2], style);
  if (heads > 1) head(points.front(), points.front() - points[1], style);
}

void Figure::circle(const Viewport& view, const Vec2& center, double radius,
                    std::string_view style) {
  svg_.circle(view.px(center), radius * view.scale, style);
}

void Figure::line(const Viewport& view, const std::vector<Vec2>& mm, std::string_view style) {
  std::vector<Vec2> points;
  for (const Vec2& p : mm) points.push_back(view.px(p));
  svg_.polyline(points, style);
}

void Figure::shape(const Viewport& view, const std::vector<Vec2>& mm, std::string_view style) {
  std::vector<Vec2> points;
  for (const Vec2& p : mm) points.push_back(view.px(p));
  svg_.polygon(points, style);
}

void Figure::dot(const Viewport& view, const Vec2& mm, std::string_view style, double radius) {
  svg_.circle(view.px(mm), radius, style);
}

void draw_frame(Figure& figure, const Plot& plot, std::string_view foot, std::string_view head,
                int columns, int rows) {
  Svg& svg = figure.svg();
  const Ticks across = columns > 0 ? round_ticks(plot.x.lo, plot.x.hi, columns) : Ticks{{}, 0};
  for (const double v : across.values) {
    svg.line({plot.x(v), plot.y.from}, {plot.x(v), plot.y.to}, "rule grid");
    svg.text({plot.x(v), plot.y.from + 17}, tick_text(v, across.decimals), Anchor::middle,
             "soft tick");
  }
  const Ticks up = round_ticks(plot.y.lo, plot.y.hi, rows);
  for (const double v : up.values) {
    svg.line({plot.x.from, plot.y(v)}, {plot.x.to, plot.y(v)}, "rule grid");
    svg.text({plot.x.from - 7, plot.y(v) + 4}, tick_text(v, up.decimals), Anchor::end, "soft tick");
  }
  svg.line({plot.x.from, plot.y.from}, {plot.x.to, plot.y.from}, "soft axis");
  svg.line({plot.x.from, plot.y.from}, {plot.x.from, plot.y.to}, "soft axis");
  figure.label({(plot.x.from + plot.x.to) / 2, plot.y.from + 37}, foot, Anchor::middle);
  figure.label({plot.x.from, plot.y.to - 9}, head);
}

void draw_curve(Figure& figure, const Plot& plot, const std::vector<Vec2>& values,
                std::string_view style) {
  std::vector<Vec2> points;
  for (const Vec2& v : values)
    if (v.allFinite()) points.push_back(plot.px(v.x(), v.y()));
  figure.svg().polyline(points, style);
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

Gear gear_of(const CylindricalSpec& spec) {
  auto gear = make_gear(spec);
  if (!gear) throw std::logic_error(gear.error().message());
  return *gear;
}

}  // namespace gearwright::figures
