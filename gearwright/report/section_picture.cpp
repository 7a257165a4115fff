#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "gearwright/base/contract.hpp"
#include "gearwright/figure/mesh.hpp"
#include "gearwright/report/crossed_figures.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/line_marks.hpp"

namespace gearwright {

namespace {

constexpr double kWidth = 640.0;
constexpr double kTallest = 460.0;
constexpr double kMargin = 82.0;  // px for labels, left and right
constexpr double kLabelGap = 19.0;

Bounds box_of_lines(const InvolutePair& pair, Lines lines) {
  Bounds box;
  for (const double rho1 : line_ends(pair)) {
    box.cover(in_section(pair, pair.on_line_of_action(rho1)));
    if (lines == Lines::both) box.cover(in_section(pair, pair.on_trailing_line(rho1)));
  }
  return box;
}

// With nearly parallel axes, the lines are far apart along the teeth. The trailing one is omitted
// if it would make the picture much smaller.
Lines lines_shown(const InvolutePair& pair) {
  const double one = box_of_lines(pair, Lines::leading).size().x();
  return box_of_lines(pair, Lines::both).size().x() > 3 * one ? Lines::leading : Lines::both;
}

Viewport window(const InvolutePair& pair) {
  Bounds box = box_of_lines(pair, lines_shown(pair));
  const double middle = (box.lo.x() + box.hi.x()) / 2;
  box.cover({middle, pair.mesh.rack.sides[0].pitch_radius});
  box.cover({middle, pair.center_distance - pair.mesh.rack.sides[1].pitch_radius});
  const double m = pair.gears[0].spec.normal_module;
  const Vec2 size = box.size().cwiseMax(Vec2(2 * m, 2 * m));
  const double scale =
      std::min((kWidth - 2 * kMargin - 60) / size.x(), (kTallest - 110) / size.y());
  // The height is only as large as the lines require, with letters and a part of the cylinders.
  return {kWidth, std::max(220.0, scale * size.y() + 110.0), (box.lo + box.hi) / 2, scale};
}

Vec2 on_ellipse(const SectionEllipse& e, double angle) {
  return e.center + Vec2(e.half_width * std::cos(angle), e.half_height * std::sin(angle));
}

bool inside(const Viewport& view, const Vec2& px) {
  return px.x() >= kMargin && px.x() <= view.width - kMargin && px.y() >= 4 &&
         px.y() <= view.height - 4;
}

// The point at which the ellipse, followed from the mesh to the `side` (+1 right), leaves the plot,
// px; none if it does not meet the plot.
std::optional<Vec2> leaves_at(const SectionEllipse& e, const Viewport& view, bool below,
                              double side) {
  constexpr int kSteps = 2000;
  std::optional<Vec2> last;
  for (int k = 0; k <= kSteps; ++k) {
    const double from_top = 0.5 * std::numbers::pi * k / kSteps;
    const double up = below ? 1.0 : -1.0;  // gear 1 is below the mesh, so its top is there
    const Vec2 p = view.px(on_ellipse(e, up * (0.5 * std::numbers::pi - side * from_top)));
    if (inside(view, p))
      last = p;
    else if (last)
      break;
  }
  return last;
}

void draw_cylinders(Svg& svg, const Viewport& view, const InvolutePair& pair, std::size_t i) {
  const double side = i == 0 ? 1.0 : -1.0;  // labels of gear 1 to the right, of gear 2 to the left
  std::vector<Vec2> ends;
  std::vector<double> wanted;
  std::vector<std::string> symbols;
  svg.begin_clip(kMargin, 0, kWidth - 2 * kMargin, view.height);
  for (const NamedCircle& cut : mesh_circles(pair, i)) {
    const SectionEllipse e = section_of_cylinder(pair, i, cut.radius);
    const Vec2 c = view.px(e.center);
    const double rx = e.half_width * view.scale;
    const double ry = e.half_height * view.scale;
    svg.path(fmt::format("M{0} {1}A{2} {3} 0 1 1 {4} {1}A{2} {3} 0 1 1 {0} {1}", pixel(c.x() - rx),
                         pixel(c.y()), pixel(rx), pixel(ry), pixel(c.x() + rx)),
             std::string("thin ") + kInk[i] + cut.style);
    if (const auto end = leaves_at(e, view, i == 0, side)) {
      ends.push_back(*end);
      wanted.push_back(end->y());
      symbols.push_back(symbol_of(cut, i));
    }
  }
  svg.end_group();
  const double radius = pair.mesh.rack.sides[i].pitch_radius;
  const double plane = view.px({0.0, i == 0 ? radius : pair.center_distance - radius}).y();
  svg.line({kMargin, plane}, {kWidth - kMargin, plane}, std::string("plane ") + kInk[i]);
  ends.push_back({side > 0 ? kWidth - kMargin : kMargin, plane});
  wanted.push_back(plane);
  symbols.push_back("plane");
  const std::vector<double> placed = spread(wanted, kLabelGap, 14.0, view.height - 12.0);
  const double x = side > 0 ? kWidth - kMargin + 16 : kMargin - 16;
  for (std::size_t k = 0; k < symbols.size(); ++k) {
    svg.polyline({ends[k], {x - 4 * side, placed[k]}}, "leader");
    const std::string words =
        symbols[k] == "plane" ? fmt::format("plane {}", i + 1) : symbol_svg(symbols[k]);
    svg.text({x, placed[k]}, words, side > 0 ? Anchor::start : Anchor::end,
             std::string("halo ") + kInk[i], {0.0, 4.0});
  }
}

std::string section_svg(const InvolutePair& pair) {
  const Viewport view = window(pair);
  Svg svg("section", kWidth, view.height, "Section normal to the teeth of the common rack",
          "Tip, pitch and base cylinders of both gears cut by the plane of the leading line of "
          "action, gear 1 below, gear 2 above, with both pitch planes and both lines of action.");
  for (const std::size_t i : {0u, 1u}) draw_cylinders(svg, view, pair, i);
  const double low = view.mm({0, view.height}).y();
  const double high = view.mm({0, 0}).y();
  svg.line(view.px({0.0, low}), view.px({0.0, high}), "thin dashdot");
  draw_lines_of_action(
      svg, pair, [&](const Point<Housing>& p) { return view.px(in_section(pair, p)); },
      lines_shown(pair));
  return svg.str();
}

}  // namespace

Vec2 in_section(const InvolutePair& pair, const Point<Housing>& p) {
  const auto& side = pair.mesh.rack.sides[0];
  const double sin_helix = side.cos_helix * side.tan_helix;
  return {sin_helix * p.r.z() - side.cos_helix * p.r.y(), p.r.x()};
}

SectionEllipse section_of_cylinder(const InvolutePair& pair, std::size_t which, double radius) {
  GW_EXPECTS(pair.crossed() && which < 2 && radius > 0.0);
  const auto& side = pair.mesh.rack.sides[which];
  const double aside = (which == 0 ? 1.0 : -1.0) * pair.mesh.line_offset * side.tan_helix;
  return {{aside, which == 0 ? 0.0 : pair.center_distance}, radius / side.cos_helix, radius};
}

std::string section_figure(const InvolutePair& pair) {
  const Mesh<double>& m = pair.mesh;
  return captioned(
      section_svg(pair),
      fmt::format(
          "<strong>Section normal to the teeth</strong> of the common rack, through the leading "
          "line, gear 1 below: the lines at their true length under {} = {}°. Tip cylinders full, "
          "pitch cylinders dash-dot, base cylinders dashed; the pitch planes lie {} = {} mm apart, "
          "the lines {} mm on either side of the centre line, along the teeth.",
          symbol_html("α_wn"),
          fixed(Angle::radians(m.rack.normal_pressure_angle).deg(), kAngleDigits), symbol_html("X"),
          fixed(m.pitch_plane_distance, kLengthDigits),
          fixed(std::abs(m.line_offset), kLengthDigits)));
}

}  // namespace gearwright
