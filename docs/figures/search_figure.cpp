// Page 9: the s1–s2 graph of one pair of tooth numbers. On a line Σ = const, every limit leaves one
// interval. The region contains the shifts that all limits allow. Right: the length of the path of
// contact along one such line.
#include <algorithm>

#include "docs/figures/figure.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/figure/shift_region.hpp"

namespace gearwright::figures {

Drawing search_figure() {
  Drawing f("09-design-search", 860, 520, "The profile shifts that all limits allow",
            "The region of profile shifts of a pair of 15 and 24 teeth within the limits of "
            "undercut, tip thickness, centre distance and contact ratio, and the length of the "
            "path of contact along one line.");
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
  // Left: the graph, with a line of constant sum.
  const double sum = 0.35;
  const ShiftSlice slice = graph.slice(sum);
  const auto on = [&](double x1) { return Vec2(x1, sum - x1); };
  const ShiftChart chart = shift_chart(graph, on(slice.lo));
  Figure left =
      shift_region_figure(chart, region_window(limits_box(graph), chart.around, 1.0, 0.0));
  left.line({on(-3.0), on(3.0)}, "action-line");
  left.line({on(slice.lo), on(slice.hi)}, "action");
  left.text(on(slice.hi), markup("a line {Σ} = 0.35: one interval"), Anchor::start, "halo here",
            {10, 0});
  left.text({limits_box(graph).lo.x(), 0.1}, "least shift of gear 1", Anchor::end, "halo edge-g1",
            {-8, 0});
  f.add(left, {0, 0}, 500);

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
  Figure right{
      "path",
      "Path of contact on a line",
      "The length of the path of contact over the profile shift of gear 1.",
      "",
      {.words = "profile shift of gear 1", .unit = {}, .lo = -0.2, .hi = 1, .symbol = "x_1"},
      {.words = "path of contact",
       .unit = "modules",
       .lo = k - 0.5,
       .hi = most + 0.15,
       .symbol = "E"}};
  right.tall = 1.45;
  right.line(std::move(path), "curve trailing-curve");
  right.line({{-kInfinity, k}, {kInfinity, k}}, "least");
  right.text({-kInfinity, k}, markup("{K}, the least length"), Anchor::start, "halo", {8, 18});
  right.line({{slice.lo, k}, {slice.hi, k}}, "action");
  const auto longest = graph.longest_path(at_sum, sum, LineEnds{-0.2, 1.0});
  right.point({longest.x1, longest.length}, 4.0, "mark", "equal tip angles", {0.0, -12.0});
  f.add(right, {510, 0}, 350);
  return f;
}

}  // namespace gearwright::figures
