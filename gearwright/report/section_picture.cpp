#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/figure/mesh.hpp"
#include "gearwright/report/crossed_figures.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/line_marks.hpp"

namespace gearwright {

namespace {

constexpr double kPlot = 480.0;                // px, width of the plot without the columns of names
constexpr double kLow = 220.0, kHigh = 460.0;  // px, limits of the height of the plot
constexpr int kEllipseSteps = 500;             // number of points on a quarter of an ellipse

Bounds box_of_lines(const CrossedPair& pair, Lines lines) {
  Bounds box;
  for (const double rho1 : line_ends(pair)) {
    box.cover(in_section(pair, pair.on_line_of_action(rho1)));
    if (lines == Lines::both) box.cover(in_section(pair, pair.on_trailing_line(rho1)));
  }
  return box;
}

// If the axes are nearly parallel, the lines of action are far apart along the teeth. The trailing
// line is omitted if it would make the picture much smaller.
Lines lines_shown(const CrossedPair& pair) {
  const double one = box_of_lines(pair, Lines::leading).size().x();
  return box_of_lines(pair, Lines::both).size().x() > 3 * one ? Lines::leading : Lines::both;
}

Bounds window(const CrossedPair& pair) {
  Bounds box = box_of_lines(pair, lines_shown(pair));
  const Vec2 middle = (box.lo + box.hi) / 2;
  box.cover({middle.x(), pair.side() * pair.mesh.rack.sides[0].pitch_radius});
  box.cover({middle.x(), pair.center_distance - pair.mesh.rack.sides[1].pitch_radius});
  const double m = pair.gears[0].spec.normal_module;
  const Vec2 size = box.size().cwiseMax(Vec2(2 * m, 2 * m));
  const double scale = std::min((kPlot - 60) / size.x(), (kHigh - 110) / size.y());  // px/mm
  // The height leaves room for the lines of action with their letters and for a part of the
  // cylinders. It is at least kLow.
  const Vec2 half = 0.5 / scale * Vec2(kPlot, std::max(kLow, scale * size.y() + 110.0));
  const Vec2 center = (box.lo + box.hi) / 2;
  return {center - half, center + half};
}

bool inside(const Figure& f, const Vec2& p) {
  return p.x() >= f.x.lo && p.x() <= f.x.hi && p.y() >= f.y.lo && p.y() <= f.y.hi;
}

// Draws the part of a cylinder's ellipse that is within the plot. The ellipse is followed from the
// mesh to the side `side` (+1 to the right). The name of the cylinder is at the point at which the
// ellipse first leaves the plot.
void add_cylinder(Figure& f, const CrossedPair& pair, std::size_t i, const NamedCircle& cut,
                  double side) {
  const SectionEllipse e = section_of_cylinder(pair, i, cut.radius);
  // The mesh is at the top of gear 1 and at the bottom of gear 2. If gear 2 is internal, the
  // mesh is at the bottom of both gears.
  const double up = i == 0 ? pair.side() : -1.0;
  const auto at = [&](int k, double to) {
    const double angle = up * kHalfPi * (1.0 - to * k / kEllipseSteps);
    return Vec2(e.center + Vec2(e.half_width * std::cos(angle), e.half_height * std::sin(angle)));
  };
  std::vector<Vec2> points;
  for (int k = -kEllipseSteps; k <= kEllipseSteps; ++k) {
    const bool near =
        inside(f, at(k - 1, side)) || inside(f, at(k, side)) || inside(f, at(k + 1, side));
    if (near)
      points.push_back(at(k, side));
    else if (!points.empty() && points.back().allFinite())
      points.push_back(kNewPiece);
  }
  f.line(std::move(points), std::string("thin ") + kInk[i] + cut.style);
  std::optional<Vec2> last;
  for (int k = 0; k <= kEllipseSteps; ++k) {
    if (inside(f, at(k, side)))
      last = at(k, side);
    else if (last)
      break;
  }
  if (last)
    f.leaders.push_back({*last, symbol_svg(symbol_of(cut, i)), std::string("halo ") + kInk[i],
                         side > 0 ? Anchor::start : Anchor::end});
}

Figure section_of(const CrossedPair& pair) {
  Figure f = plane_figure(
      "section", "Section normal to the teeth",
      fmt::format("Sections of the tip, pitch and base cylinders of both gears in the plane of the "
                  "leading line of action ({}), with both pitch planes and both lines of action.",
                  pair.side() > 0.0 ? "gear 1 below, gear 2 above" : "both axes above"),
      window(pair));
  for (const std::size_t i : {0u, 1u}) {
    // Names of gear 1 are on the right, and names of gear 2 on the left.
    const double side = i == 0 ? 1.0 : -1.0;
    for (const NamedCircle& cut : mesh_circles(pair, i)) add_cylinder(f, pair, i, cut, side);
    const double radius = pair.mesh.rack.sides[i].pitch_radius;
    const double plane = i == 0 ? pair.side() * radius : pair.center_distance - radius;
    f.line({{f.x.lo, plane}, {f.x.hi, plane}}, std::string("plane ") + kInk[i]);
    f.leaders.push_back({{side > 0 ? f.x.hi : f.x.lo, plane},
                         fmt::format("plane {}", i + 1),
                         std::string("halo ") + kInk[i],
                         side > 0 ? Anchor::start : Anchor::end});
  }
  f.line({{0.0, f.y.lo}, {0.0, f.y.hi}}, "thin dashdot");
  add_lines_of_action(
      f, pair, [&](const Point<Housing>& p) { return in_section(pair, p); }, lines_shown(pair));
  return f;
}

}  // namespace

Vec2 in_section(const CrossedPair& pair, const Point<Housing>& p) {
  const auto& side = pair.mesh.rack.sides[0];
  const double sin_helix = side.cos_helix * side.tan_helix;
  return {sin_helix * p.r.z() - pair.side() * side.cos_helix * p.r.y(), p.r.x()};
}

SectionEllipse section_of_cylinder(const CrossedPair& pair, std::size_t which, double radius) {
  GW_EXPECTS(which < 2 && radius > 0.0);
  const auto& side = pair.mesh.rack.sides[which];
  const double aside = (which == 0 ? 1.0 : -pair.side()) * pair.mesh.line_offset * side.tan_helix;
  return {{aside, which == 0 ? 0.0 : pair.center_distance}, radius / side.cos_helix, radius};
}

Figure section_figure(const CrossedPair& pair) {
  const Mesh<double>& m = pair.mesh;
  Figure f = section_of(pair);
  f.caption = fmt::format(
      " of the common rack, through the leading line, with {}. The lines are drawn in true length, "
      "at the angle {} = {}°. Tip cylinders are full, pitch cylinders dash-dotted and base "
      "cylinders dashed. The pitch planes are {} = {} mm apart, and each line is {} mm from the "
      "centre line, measured along the teeth.",
      pair.side() > 0.0 ? "gear 1 below" : "both axes above", symbol_html("α_wn"),
      fixed(Angle::radians(m.rack.normal_pressure_angle).deg(), kAngleDigits), symbol_html("X"),
      fixed(m.pitch_plane_distance, kLengthDigits), fixed(std::abs(m.line_offset), kLengthDigits));
  return f;
}

}  // namespace gearwright
