#include "gearwright/report/k_diagram.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gearwright/base/numbers.hpp"
#include "gearwright/catalogue/figure_units.hpp"
#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/figure/ticks.hpp"
#include "gearwright/report/html_text.hpp"

namespace gearwright {

namespace {

constexpr double kFlat = 1.0;  // µm; least range of the axis of deviations

// Returns the tolerance band over the evaluation range. Its borders are the design trace, moved up
// and moved down by half of the tolerance.
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

Figure trace_figure(const std::string& id, const std::string& title, const FlankTrace& trace,
                    const char* across) {
  const double half = trace.tolerance.value_or(0.0) / 2;
  double lo = -half, hi = half;
  for (const Vec2& p : trace.design) {
    lo = std::min(lo, p.y() - half);
    hi = std::max(hi, p.y() + half);
  }
  const double spare = std::max(0.0, kFlat - (hi - lo)) / 2;
  const auto ends = widened(lo - spare, hi + spare, 0.15);
  Figure f{id,
           title,
           title + ", with the design flank and the tolerance band over the evaluation range.",
           ", with the design",
           {across, "mm", trace.design.front().x(), trace.design.back().x()},
           {"deviation out of the material", "µm", ends[0], ends[1]}};
  if (trace.tolerance) {
    f.caption +=
        fmt::format(" and the band of {} µm in which a trace must lie", fixed(*trace.tolerance, 1));
    f.area(band(trace), "neighbour");
  }
  for (const double end : trace.evaluation) f.line({{end, -kInfinity}, {end, kInfinity}}, "leader");
  f.line(trace.design, "curve action-curve", "design");
  return f;
}

}  // namespace

std::string k_figures(const std::vector<KDiagram>& diagrams, UnitSystem units) {
  std::string text;
  for (std::size_t i = 0; i < diagrams.size(); ++i) {
    const auto figure = [&](const char* kind, const FlankTrace& trace, const char* across) {
      text +=
          figure_html(in_units(units, trace_figure(fmt::format("k{}-{}", i + 1, kind),
                                                   diagrams[i].name + ", " + kind, trace, across)));
    };
    figure("profile", diagrams[i].profile, "roll length");
    figure("helix", diagrams[i].helix, "height from the middle of the face");
  }
  return text.empty() ? text : side_by_side(text);
}

}  // namespace gearwright
