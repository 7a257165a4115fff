#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gearwright/report/html_text.hpp"
#include "gearwright/report/named_circles.hpp"
#include "gearwright/report/pair_figures.hpp"

namespace gearwright {

namespace {

constexpr double kWidth = 520.0;
constexpr double kHeight = 400.0;
constexpr double kMinShift = 0.02;  // m_n; smaller shifts are not visible

struct Centrodes {
  std::array<double, 2> reference, working;  // radii, mm
  double side_1, side_2;                     // direction of the mesh from each axis: ±1
  double a_d, a;                             // mm
};

Centrodes centrodes_of(const InvolutePair& pair) {
  Centrodes c{};
  for (const std::size_t i : {0u, 1u}) {
    c.reference[i] = pair.gears[i].reference_diameter / 2;
    c.working[i] = pair.mesh.rack.sides[i].pitch_radius;
  }
  c.side_1 = pair.kind == PairKind::parallel_internal ? -1.0 : 1.0;
  c.side_2 = -1.0;
  c.a_d = pair.reference_center_distance;
  c.a = pair.center_distance;
  return c;
}

Viewport window(const InvolutePair& pair, const Centrodes& c) {
  const double shift = std::abs(c.a - c.a_d);
  const double half = std::max(3.2 * shift, 1.2 * pair.gears[0].spec.normal_module);
  return {kWidth, kHeight, Vec2(c.side_1 * c.reference[0], 0.0), kHeight / (2 * half)};
}

// A dimension between two points on the centre line, below it. Its arrows are inside, or outside if
// there is no room.
void draw_dimension(Svg& svg, const Vec2& a, const Vec2& b, double below,
                    const std::string& markup) {
  const Vec2 lo = a.x() < b.x() ? a : b;
  const Vec2 hi = a.x() < b.x() ? b : a;
  const double y = lo.y() + below;
  for (const Vec2& p : {lo, hi}) svg.line(p, {p.x(), y + 6}, "leader");
  const bool inside = hi.x() - lo.x() > 44.0;
  const double out = inside ? 0.0 : 26.0;
  svg.line({lo.x() - out, y}, {hi.x() + out, y}, "thin");
  for (const double s : {-1.0, 1.0}) {
    const double tip = s < 0.0 ? lo.x() : hi.x();
    const double back = (inside ? -s : s) * 8.0;
    svg.polygon({{tip, y}, {tip + back, y - 3.2}, {tip + back, y + 3.2}}, "mark");
  }
  // The words are next to the dimension, because the pitch circles pass between its ends.
  svg.text({hi.x() + out, y}, markup, Anchor::start, "halo", {8.0, 4.5});
}

void draw_axes(Svg& svg, const Viewport& view, double a) {
  svg.line({0, view.height / 2}, {view.width, view.height / 2}, "thin dashdot");
  for (const Vec2& axis : {Vec2(0.0, 0.0), Vec2(a, 0.0)}) {
    const Vec2 p = view.px(axis);
    if (p.x() < 8 || p.x() > view.width - 8) continue;
    svg.line(p - Vec2(6, 0), p + Vec2(6, 0), "cross");
    svg.line(p - Vec2(0, 6), p + Vec2(0, 6), "cross");
  }
}

std::string before_svg(const Viewport& view, const Centrodes& c) {
  Svg svg("centrodes-before", kWidth, kHeight, "Reference circles at the reference distance",
          "The reference circles of both gears near the mesh, touching on the centre line at I.");
  draw_axes(svg, view, c.a_d);
  draw_named_circles(svg, view, {0.0, 0.0}, c.side_1, 0, {{"d_1", c.reference[0], " dashdot"}});
  draw_named_circles(svg, view, {c.a_d, 0.0}, c.side_2, 1, {{"d_2", c.reference[1], " dashdot"}});
  const Vec2 I = view.px({c.side_1 * c.reference[0], 0.0});
  svg.dot(I, 3.6, "mark");
  svg.text(I, "I", Anchor::start, "letter halo", {9.0, -8.0});
  return svg.str();
}

std::string after_svg(const Viewport& view, const Centrodes& c) {
  Svg svg("centrodes-after", kWidth, kHeight, "Working pitch circles at the pair's distance",
          "Reference circles and working pitch circles of both gears near the mesh; the pitch "
          "circles touch on the centre line at the pitch point I′.");
  draw_axes(svg, view, c.a);
  draw_named_circles(svg, view, {0.0, 0.0}, c.side_1, 0,
                     {{"d_1", c.reference[0], " dashdot"}, {"d_w1", c.working[0], " full"}});
  draw_named_circles(svg, view, {c.a, 0.0}, c.side_2, 1,
                     {{"d_2", c.reference[1], " dashdot"}, {"d_w2", c.working[1], " full"}});
  const Vec2 now = view.px({c.side_1 * c.working[0], 0.0});
  svg.dot(now, 3.6, "mark");
  svg.text(now, "I′", Anchor::start, "letter halo", {9.0, -8.0});
  draw_dimension(svg, view.px({c.side_1 * c.reference[0], 0.0}),
                 view.px({c.a + c.side_2 * c.reference[1], 0.0}), 60.0,
                 fixed(std::abs(c.a - c.a_d), kLengthDigits));
  return svg.str();
}

}  // namespace

bool centrodes_are_worth_a_picture(const InvolutePair& pair) {
  if (pair.crossed()) return false;
  const double sum = pair.gears[0].spec.profile_shift + pair.gears[1].spec.profile_shift;
  const bool reason = sum != 0.0 || pair.gears[0].cut_by || pair.gears[1].cut_by;
  const double shift = std::abs(pair.center_distance - pair.reference_center_distance);
  return reason && shift >= kMinShift * pair.gears[0].spec.normal_module;
}

std::string centrode_figures(const InvolutePair& pair) {
  if (!centrodes_are_worth_a_picture(pair)) return {};
  const Centrodes c = centrodes_of(pair);
  const Viewport view = window(pair, c);
  const double sum = pair.gears[0].spec.profile_shift + pair.gears[1].spec.profile_shift;
  const std::string before = fmt::format(
      "<strong>Before the shift</strong>: at {} = {} mm the reference circles touch at I and roll "
      "on "
      "each other.",
      symbol_html("a_d"), fixed(c.a_d, kLengthDigits));
  const std::string after = fmt::format(
      "<strong>After it</strong>: with {} + {} = {} the axes stand {} = {} mm apart. The working "
      "pitch circles (full) roll on each other at I′ in the same ratio; the reference circles "
      "(dash-dot) {} by {} mm.",
      symbol_html("x_1"), symbol_html("x_2"), fixed(sum, kRatioDigits), symbol_html("a"),
      fixed(c.a, kLengthDigits), (c.a - c.a_d) * c.side_1 > 0.0 ? "are apart" : "overlap",
      fixed(std::abs(c.a - c.a_d), kLengthDigits));
  return "<h3>Centrodes</h3>\n" + side_by_side(captioned(before_svg(view, c), before) +
                                               captioned(after_svg(view, c), after));
}

}  // namespace gearwright
