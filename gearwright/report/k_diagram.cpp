#include "gearwright/report/k_diagram.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gearwright/report/html_text.hpp"
#include "gearwright/report/plot_axis.hpp"

namespace gearwright {

namespace {

constexpr PlotArea kArea{460, 58, 18, 34, 190, 50};
constexpr double kFlat = 1.0;  // µm: a trace that moves by less is drawn on this scale

// The band: the design moved by half of the tolerance either way, over the evaluation range.
std::vector<Vec2> band(const FlankTrace& trace) {
  std::vector<Vec2> upper, lower;
  for (const Vec2& p : trace.design) {
    if (p.x() < trace.evaluation[0] || p.x() > trace.evaluation[1]) continue;
    upper.push_back(p + Vec2(0, *trace.tolerance / 2));
    lower.push_back(p - Vec2(0, *trace.tolerance / 2));
  }
  upper.insert(upper.end(), lower.rbegin(), lower.rend());
  return upper;
}

std::string trace_svg(const std::string& id, const std::string& title, const FlankTrace& trace,
                      const char* foot) {
  const double half = trace.tolerance.value_or(0.0) / 2;
  double lo = -half, hi = half;
  for (const Vec2& p : trace.design) {
    lo = std::min(lo, p.y() - half);
    hi = std::max(hi, p.y() + half);
  }
  const double spare = std::max(0.0, kFlat - (hi - lo)) / 2;
  const auto ends = widened(lo - spare, hi + spare, 0.15);
  const Axis x = kArea.across(trace.design.front().x(), trace.design.back().x());
  const Axis y = kArea.up(ends[0], ends[1]);
  Svg svg(id, kArea.width, kArea.height(), title,
          title + ": the design flank, and the band of its tolerance where it is evaluated.");
  draw_rows(svg, x, y, 5);
  draw_foot(svg, x, kArea.top, kArea.bottom(), 6, foot);
  svg.text({x.from, kArea.top - 14}, "µm, up is out of the material", Anchor::start, "panel");
  if (trace.tolerance) {
    std::vector<Vec2> shape;
    for (const Vec2& p : band(trace)) shape.push_back({x(p.x()), y(p.y())});
    if (shape.size() > 2) svg.polygon(shape, "neighbour");
  }
  for (const double end : trace.evaluation)
    svg.line({x(end), kArea.top}, {x(end), kArea.bottom()}, "leader");
  draw_curve(svg, x, y, trace.design, "curve action-curve");
  return svg.str();
}

}  // namespace

std::string k_figures(const std::vector<KDiagram>& diagrams) {
  std::string text;
  for (std::size_t i = 0; i < diagrams.size(); ++i) {
    const KDiagram& d = diagrams[i];
    const auto figure = [&](const char* kind, const FlankTrace& trace, const char* foot) {
      const std::string title = d.name + ", " + kind;
      const std::string band = trace.tolerance
                                   ? fmt::format(" and the band of {} µm in which a trace must lie",
                                                 fixed(*trace.tolerance, 1))
                                   : std::string();
      text += captioned(trace_svg(fmt::format("k{}-{}", i + 1, kind), title, trace, foot),
                        fmt::format("<strong>{}</strong>: the design{}", escaped(title), band));
    };
    figure("profile", d.profile, "roll length, mm");
    figure("helix", d.helix, "height from the middle of the face, mm");
  }
  return text.empty() ? text : side_by_side(text);
}

}  // namespace gearwright
