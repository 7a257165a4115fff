#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gearwright/report/html_text.hpp"
#include "gearwright/report/pair_figures.hpp"

namespace gearwright {

namespace {

constexpr double kCentrodeAspect = 520.0 / 400.0;
constexpr double kMinShift = 0.02;  // m_n; a smaller |a − a_d| is not visible

struct Centrodes {
  std::array<double, 2> reference, working;  // radii, mm
  double side_1, side_2;  // ±1, direction along x from axis 1 and from axis 2 to the mesh
  double a_d, a;          // reference and actual centre distance, mm
};

Centrodes centrodes_of(const InvolutePair& pair) {
  Centrodes c{};
  for (const std::size_t i : {0u, 1u}) {
    c.reference[i] = pair.gears[i].reference_diameter / 2;
    c.working[i] = pair.mesh.rack.sides[i].pitch_radius;
  }
  c.side_1 = pair.side();
  c.side_2 = -1.0;
  c.a_d = pair.reference_center_distance;
  c.a = pair.center_distance;
  return c;
}

double half_height(const InvolutePair& pair, const Centrodes& c) {
  return std::max(3.2 * std::abs(c.a - c.a_d), 1.2 * pair.gears[0].spec.normal_module);
}

Figure with_axes(const std::string& id, const std::string& title, const std::string& description,
                 const Centrodes& c, double half, double a) {
  const Vec2 I(c.side_1 * c.reference[0], 0.0), corner(half * kCentrodeAspect, half);
  Figure f = plane_figure(id, title, description, {I - corner, I + corner});
  f.line({I - Vec2(corner.x(), 0.0), I + Vec2(corner.x(), 0.0)}, "thin dashdot");
  f.cross({0.0, 0.0});
  f.cross({a, 0.0});
  f.circle({0.0, 0.0}, c.reference[0], "thin g1 dashdot", 0, symbol_svg("d_1"));
  f.circle({a, 0.0}, c.reference[1], "thin g2 dashdot", 1, symbol_svg("d_2"));
  return f;
}

// Draws the dimension of the distance between two points of the centre line. The dimension is below
// the centre line. Its arrows are between the points, or outside the points if there is no room.
// The text is beside the dimension, because the pitch circles pass through the space between the
// points.
void add_dimension(Figure& f, double x_1, double x_2, double length) {
  const double unit = (f.x.hi - f.x.lo) / kPlaneFigure;  // mm per px
  const auto [lo, hi] = std::minmax(x_1, x_2);
  const double y = -60.0 * unit;
  for (const double x : {lo, hi}) f.line({Vec2(x, 0.0), Vec2(x, y - 6.0 * unit)}, "leader");
  const bool inside = hi - lo > 44.0 * unit;
  const double out = inside ? 0.0 : 26.0 * unit, middle = (lo + hi) / 2;
  if (!inside) f.line({Vec2(lo, y), Vec2(hi, y)}, "thin");
  for (const double tip : {lo, hi}) {
    const double from = inside ? middle : tip == lo ? lo - out : hi + out;
    f.line({Vec2(from, y), Vec2(tip, y)}, "thin");
    f.marks.back().head = true;
  }
  f.text({hi + out, y}, "", Anchor::start, "halo", {8.0, 4.5});
  f.marks.back().length = {length, kLengthDigits};
}

Figure before_figure(const Centrodes& c, double half) {
  Figure f = with_axes("centrodes-before", "Without profile shift",
                       "The reference circles of both gears near the mesh, touching on the centre "
                       "line at I.",
                       c, half, c.a_d);
  f.point({c.side_1 * c.reference[0], 0.0}, 3.6, "mark", "I", {12.0, -12.0});
  return f;
}

Figure after_figure(const Centrodes& c, double half) {
  Figure f = with_axes("centrodes-after", "With profile shift",
                       "Reference circles and working pitch circles of both gears near the mesh; "
                       "the pitch circles touch on the centre line at the pitch point I′.",
                       c, half, c.a);
  f.circle({0.0, 0.0}, c.working[0], "thin g1 full", 0, symbol_svg("d_w1"));
  f.circle({c.a, 0.0}, c.working[1], "thin g2 full", 1, symbol_svg("d_w2"));
  f.point({c.side_1 * c.working[0], 0.0}, 3.6, "mark", "I′", {12.0, -12.0});
  add_dimension(f, c.side_1 * c.reference[0], c.a + c.side_2 * c.reference[1],
                std::abs(c.a - c.a_d));
  return f;
}

}  // namespace

bool centrodes_are_worth_a_picture(const InvolutePair& pair) {
  if (pair.crossed()) return false;
  const double sum = pair.gears[0].spec.profile_shift + pair.gears[1].spec.profile_shift;
  const bool reason = sum != 0.0 || pair.gears[0].cut_by || pair.gears[1].cut_by;
  const double shift = std::abs(pair.center_distance - pair.reference_center_distance);
  return reason && shift >= kMinShift * pair.gears[0].spec.normal_module;
}

std::string centrode_figures(const InvolutePair& pair, const FigureForm& form) {
  if (!centrodes_are_worth_a_picture(pair)) return {};
  const Centrodes c = centrodes_of(pair);
  const double half = half_height(pair, c);
  const double sum = pair.gears[0].spec.profile_shift + pair.gears[1].spec.profile_shift;
  Figure before = before_figure(c, half), after = after_figure(c, half);
  before.caption = fmt::format(
      ", with the axes {} = {} mm apart. The reference circles touch at I and roll on each other.",
      symbol_html("a_d"), fixed(c.a_d, kLengthDigits));
  after.caption = fmt::format(
      " {} + {} = {}, with the axes {} = {} mm apart. The working pitch circles (full) roll on "
      "each other at I′ in the same ratio, and the reference circles (dash-dotted) {} by {} mm.",
      symbol_html("x_1"), symbol_html("x_2"), fixed(sum, kRatioDigits), symbol_html("a"),
      fixed(c.a, kLengthDigits), (c.a - c.a_d) * c.side_1 > 0.0 ? "are apart" : "overlap",
      fixed(std::abs(c.a - c.a_d), kLengthDigits));
  return "<h3>Centrodes</h3>\n" +
         side_by_side(form.html(before, kPlaneFigure) + form.html(after, kPlaneFigure));
}

}  // namespace gearwright
