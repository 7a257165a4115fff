#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/report/html_text.hpp"
#include "gearwright/report/pair_figures.hpp"

namespace gearwright {

namespace {

constexpr double kCentrodeAspect = 520.0 / 400.0;
constexpr double kMinShift = 0.02;  // m_n; a smaller |a − a_d| is not visible

double reference_radius(const ParallelPair& pair, std::size_t i) {
  return pair.gears[i].reference_diameter / 2;
}

// a − a_d, mm
double shift_of(const ParallelPair& pair) {
  return pair.center_distance - pair.reference_center_distance;
}

// Draws the reference circles near the mesh, with the axes at the centre distance a.
Figure with_axes(const std::string& id, const std::string& title, const std::string& description,
                 const ParallelPair& pair, double a) {
  const double r_1 = reference_radius(pair, 0), r_2 = reference_radius(pair, 1);
  const double half =
      std::max(3.2 * std::abs(shift_of(pair)), 1.2 * pair.gears[0].spec.normal_module);
  const Vec2 I(pair.side() * r_1, 0.0), corner(half * kCentrodeAspect, half);
  Figure f = plane_figure(id, title, description, {I - corner, I + corner});
  f.line({I - Vec2(corner.x(), 0.0), I + Vec2(corner.x(), 0.0)}, "thin dashdot");
  f.cross({0.0, 0.0});
  f.cross({a, 0.0});
  f.circle({0.0, 0.0}, r_1, "thin g1 dashdot", 0, symbol_svg("d_1"));
  f.circle({a, 0.0}, r_2, "thin g2 dashdot", 1, symbol_svg("d_2"));
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

Figure before_figure(const ParallelPair& pair) {
  Figure f = with_axes("centrodes-before", "Without profile shift",
                       "The reference circles of both gears near the mesh, touching on the centre "
                       "line at I.",
                       pair, pair.reference_center_distance);
  f.point({pair.side() * reference_radius(pair, 0), 0.0}, 3.6, "mark", "I", {12.0, -12.0});
  return f;
}

Figure after_figure(const ParallelPair& pair) {
  const double a = pair.center_distance;
  Figure f = with_axes("centrodes-after", "With profile shift",
                       "Reference circles and working pitch circles of both gears near the mesh; "
                       "the pitch circles touch on the centre line at the pitch point I′.",
                       pair, a);
  const double r_w1 = pair.mesh.rack.sides[0].pitch_radius;
  f.circle({0.0, 0.0}, r_w1, "thin g1 full", 0, symbol_svg("d_w1"));
  f.circle({a, 0.0}, pair.mesh.rack.sides[1].pitch_radius, "thin g2 full", 1, symbol_svg("d_w2"));
  f.point({pair.side() * r_w1, 0.0}, 3.6, "mark", "I′", {12.0, -12.0});
  add_dimension(f, pair.side() * reference_radius(pair, 0), a - reference_radius(pair, 1),
                std::abs(shift_of(pair)));
  return f;
}

}  // namespace

bool centrodes_are_worth_a_picture(const ParallelPair& pair) {
  const double sum = pair.gears[0].spec.profile_shift + pair.gears[1].spec.profile_shift;
  const bool reason = sum != 0.0 || pair.gears[0].cut_by || pair.gears[1].cut_by;
  return reason && std::abs(shift_of(pair)) >= kMinShift * pair.gears[0].spec.normal_module;
}

std::string centrode_figures(const ParallelPair& pair, const FigureForm& form) {
  if (!centrodes_are_worth_a_picture(pair)) return {};
  const double shift = shift_of(pair);
  const double sum = pair.gears[0].spec.profile_shift + pair.gears[1].spec.profile_shift;
  Figure before = before_figure(pair), after = after_figure(pair);
  before.caption = fmt::format(
      ", with the axes {} = {} mm apart. The reference circles touch at I and roll on each other.",
      symbol_html("a_d"), fixed(pair.reference_center_distance, kLengthDigits));
  after.caption = fmt::format(
      " {} + {} = {}, with the axes {} = {} mm apart. The working pitch circles (full) roll on "
      "each other at I′ in the same ratio, and the reference circles (dash-dotted) {} by {} mm.",
      symbol_html("x_1"), symbol_html("x_2"), fixed(sum, kRatioDigits), symbol_html("a"),
      fixed(pair.center_distance, kLengthDigits),
      shift * pair.side() > 0.0 ? "are apart" : "overlap", fixed(std::abs(shift), kLengthDigits));
  return "<h3>Centrodes</h3>\n" +
         side_by_side(form.html(before, kPlaneFigure) + form.html(after, kPlaneFigure));
}

}  // namespace gearwright
