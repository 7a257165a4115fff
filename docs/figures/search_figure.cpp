// Page 9: the s1–s2 graph of one pair of tooth numbers. On a line Σ = const, every limit leaves one
// interval. The region contains the shifts that all limits allow. Right: the length of the path of
// contact along one such line.
#include <array>
#include <cmath>
#include <stdexcept>

#include "docs/figures/figure.hpp"
#include "gearwright/design/shift_region.hpp"

namespace gearwright::figures {

namespace {

const char* words_for(ShiftEdge edge) {
  switch (edge) {
    case ShiftEdge::s1min: return "undercut of gear 1";
    case ShiftEdge::s1max: return "tip of gear 1";
    case ShiftEdge::s2min: return "undercut of gear 2";
    case ShiftEdge::s2max: return "tip of gear 2";
    case ShiftEdge::Cmin: return "least centre distance";
    case ShiftEdge::Cmax: return "greatest centre distance";
    case ShiftEdge::eps: return "contact ratio";
    case ShiftEdge::sliding: return "specific sliding";
    default: return "";
  }
}

}  // namespace

Figure search_figure() {
  Figure f("09-design-search", 860, 520, "What every limit leaves of the two profile shifts",
           "The region of profile shifts of a pair of 15 and 24 teeth between undercut, tip "
           "thickness, centre "
           "distance and contact ratio, and the length of the path of contact along one line.");
  SearchProblem problem;
  problem.modules = {1.0};
  problem.ratio = {1.5, 1.7};
  problem.pinion_teeth = {15, 15};
  problem.center_distance = {{19.42, 20.35}};
  problem.limits.contact_ratio = 1.4;
  problem.limits.tip_thickness = 0.3;
  problem.limits.min_shift = -0.5;
  Trial trial;
  trial.module = 1.0;
  trial.z1 = 15;
  trial.z2 = 24;
  const ShiftGraph graph(problem, trial, trial_gear(problem, 15, Angle(), 0, 0),
                         trial_gear(problem, 24, Angle(), 0, 1));
  const auto region = shift_region(graph);
  if (!region) throw std::logic_error("the figure's region is empty");

  // Left: the graph.
  const Plot plot{{-0.4, 1.0, 62, 492}, {-0.75, 0.95, 470, 36}};
  draw_frame(f, plot, "profile shift {x1}", "profile shift {x2}", 6, 8);
  const auto& [one, two] = graph.gears();
  const auto clip = [&](double x) { return std::min(std::max(x, -2.0), 2.0); };
  f.svg().begin_clip(62, 36, 430, 434);
  f.svg().polygon({plot.px(one.x_min, two.x_min), plot.px(clip(one.x_max), two.x_min),
                   plot.px(clip(one.x_max), clip(two.x_max)), plot.px(one.x_min, clip(two.x_max))},
                  "soft dash");
  const auto loops = region_boundary(graph, *region);
  for (const auto& loop : loops) {
    std::vector<Vec2> outline;
    for (const RegionEdge& edge : loop)
      for (const Vec2& p : edge.points) outline.push_back(plot.px(p.x(), p.y()));
    f.svg().polygon(outline, "band");
  }
  const double sum = 0.35;
  f.svg().line(plot.px(-1.0, sum + 1.0), plot.px(2.0, sum - 2.0), "action dash");
  f.svg().end_group();
  const std::array styles{"g1 thick",  "g2 thick",  "g1 thick",   "g2 thick",
                          "ink thick", "ink thick", "green heavy"};
  for (const auto& loop : loops) {
    for (const RegionEdge& edge : loop) {
      std::vector<Vec2> points;
      for (const Vec2& p : edge.points) points.push_back(plot.px(p.x(), p.y()));
      const std::size_t at = static_cast<std::size_t>(edge.edge);
      f.svg().polyline(points, at < styles.size() ? styles[at] : "ink thick");
      const Vec2 middle = 0.5 * (edge.points.front() + edge.points.back());
      const Vec2 along = edge.points.back() - edge.points.front();
      const Vec2 out = Vec2(along.y(), along.x()).normalized();  // away from the region; px, y down
      if (along.norm() < 0.05) continue;
      const Anchor anchor = out.x() > 0.3    ? Anchor::start
                            : out.x() < -0.3 ? Anchor::end
                                             : Anchor::middle;
      f.label(plot.px(middle.x(), middle.y()), words_for(edge.edge), anchor, 12 * out + Vec2(0, 4),
              "small halo");
    }
  }
  f.label(plot.px(one.x_max, 0.92), "the limits of each gear", Anchor::start, {8, 4},
          "soft small halo");
  const ShiftSlice slice = graph.slice(sum);
  f.svg().line(plot.px(slice.lo, sum - slice.lo), plot.px(slice.hi, sum - slice.hi),
               "action heavy");
  f.label(plot.px(slice.hi, sum - slice.hi), "a line {Σ} = 0.35: one interval", Anchor::start,
          {12, 18}, "action small halo");
  f.svg().circle(plot.px(region->lo.x(), region->lo.y()), 4, "fill-ink");
  f.svg().circle(plot.px(region->hi.x(), region->hi.y()), 4, "fill-ink");
  f.label(plot.px(region->lo.x(), region->lo.y()), "lo", Anchor::start, {8, -6}, "bold small halo");
  f.label(plot.px(region->hi.x(), region->hi.y()), "hi", Anchor::start, {9, -4}, "bold small halo");
  if (region->balanced) {
    f.svg().circle(plot.px(region->balanced->x(), region->balanced->y()), 4.5, "fill-g2");
    f.label(plot.px(region->balanced->x(), region->balanced->y()), "Eq. 11", Anchor::start, {8, -6},
            "g2 small halo");
  }

  // Right: E along that line is a concave function of x1. K is the least permissible length.
  const SumPlace at_sum = graph.place(sum);
  std::vector<Vec2> path;
  double most = 0;
  for (int i = 0; i <= 100; ++i) {
    const double x1 = -0.2 + 1.2 * i / 100;
    path.push_back({x1, graph.path_length(at_sum, sum, x1)});
    most = std::max(most, path.back().y());
  }
  const double k = graph.min_path();
  const Plot right{{-0.2, 1.0, 580, 838}, {k - 0.5, most + 0.15, 470, 36}};
  draw_frame(f, right, "{x1} along the line", "path of contact {E}, modules", 4, 6);
  f.svg().begin_clip(580, 36, 258, 434);
  draw_curve(f, right, path, "green thick");
  f.svg().end_group();
  f.svg().line(right.px(-0.2, k), right.px(1.0, k), "ink dash");
  f.label(right.px(-0.2, k), "{K}, the least length asked", Anchor::start, {8, 18}, "small halo");
  const auto longest = graph.longest_path(at_sum, sum, LineEnds{-0.2, 1.0});
  f.svg().circle(right.px(longest.x1, longest.length), 4.5, "fill-green");
  f.label(right.px(longest.x1, longest.length), "equal tip angles", Anchor::start, {6, -9},
          "green small halo");
  f.svg().line(right.px(slice.lo, k), right.px(slice.hi, k), "action heavy");
  return f;
}

}  // namespace gearwright::figures
