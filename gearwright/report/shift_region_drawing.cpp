#include "gearwright/report/shift_region_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/math/root.hpp"
#include "gearwright/report/search_words.hpp"

namespace gearwright {

namespace {

constexpr double kPadding = 0.17;      // of the rectangle around it
constexpr double kZoomPadding = 0.42;  // of a region: room for its labels
constexpr double kMinWindow = 1e-3;    // modules: a hundredth of the resolution of a cutter setting

// The piece of Σ = const inside the window; empty: none.
std::vector<Vec2> line_of_sum(const Bounds& box, double sum) {
  const double from = std::max(box.lo.x(), sum - box.hi.y());
  const double to = std::min(box.hi.x(), sum - box.lo.y());
  if (!(from < to)) return {};
  return {{from, sum - from}, {to, sum - to}};
}

}  // namespace

Bounds limits_box(const ShiftGraph& graph) {
  const auto& [g_1, g_2] = graph.gears();
  return {{g_1.x_min, g_2.x_min}, {g_1.x_max, g_2.x_max}};
}

RegionWindow region_window(const Bounds& limits, const Bounds& region, double aspect,
                           double fair_part) {
  const bool zoomed = region.size().maxCoeff() < fair_part * limits.size().maxCoeff();
  Bounds box = region;
  double pad = kZoomPadding * std::max(region.size().maxCoeff(), kMinWindow);
  if (!zoomed) {
    box.cover(limits.lo);
    box.cover(limits.hi);
    pad = kPadding * std::max(box.size().maxCoeff(), kMinWindow);
  }
  const Vec2 size = box.size() + 2 * Vec2(pad, pad);
  const double height = std::max(size.y(), size.x() / aspect);
  const Vec2 half(aspect * height / 2, height / 2);
  const Vec2 middle = (box.lo + box.hi) / 2;
  return {{middle - half, middle + half}, zoomed};
}

std::optional<double> sum_at_distance(const ShiftGraph& graph, double a, const Bounds& window) {
  const double module = graph.trial().module;
  const double lo = window.lo.sum();
  const double hi = window.hi.sum();
  if (!(lo < hi)) return std::nullopt;
  const auto more = [&](double sum) { return module * std::abs(graph.place(sum).a) - a; };
  const Root root = find_root(more, lo, hi);
  return root.found() ? std::optional(root.x) : std::nullopt;
}

std::vector<Vec2> GraphFrame::px(const std::vector<Vec2>& points) const {
  std::vector<Vec2> found;
  for (const Vec2& p : points) found.push_back(px(p));
  return found;
}

GraphFrame frame_on(const Bounds& box, const PixelBox& place) {
  return {{box.lo.x(), box.hi.x(), place.left, place.right},
          {box.lo.y(), box.hi.y(), place.bottom, place.top}};
}

std::vector<Vec2> outline_of(const std::vector<RegionEdge>& loop) {
  std::vector<Vec2> points;
  for (const RegionEdge& e : loop) points.insert(points.end(), e.points.begin(), e.points.end());
  return points;
}

void draw_box(Svg& svg, const GraphFrame& g, const Bounds& box, std::string_view style) {
  const Vec2 corner = g.px(Vec2(box.lo.x(), box.hi.y()));
  const Vec2 other = g.px(Vec2(box.hi.x(), box.lo.y()));
  svg.rect(corner.x(), corner.y(), other.x() - corner.x(), other.y() - corner.y(), style);
}

void draw_region(Svg& svg, const GraphFrame& g, const Loops& loops, const ShiftRegion& region) {
  for (const auto& loop : loops) {
    const std::vector<Vec2> outline = g.px(outline_of(loop));
    if (outline.size() > 2) svg.polygon(outline, "region");
    for (const RegionEdge& e : loop)
      svg.polyline(g.px(e.points), fmt::format("region-edge {}", style_of(e.edge)));
    if (loop.empty()) svg.dot(g.px(region.lo), 3.0, "region-point");  // touching in a point
  }
}

bool exact_distance(const SearchProblem& problem) {
  const auto& band = problem.center_distance;
  return band && (*band)[0] == (*band)[1];
}

std::vector<DistanceLine> draw_distances(Svg& svg, const ShiftGraph& graph, const GraphFrame& g) {
  std::vector<DistanceLine> lines;
  const auto& band = graph.problem().center_distance;
  if (!band) return lines;
  const std::size_t n = exact_distance(graph.problem()) ? 1 : 2;
  for (std::size_t i = 0; i < n; ++i) {
    const auto sum = sum_at_distance(graph, (*band)[i], g.box());
    const std::vector<Vec2> line = sum ? line_of_sum(g.box(), *sum) : std::vector<Vec2>();
    if (line.empty()) continue;
    lines.push_back({(*band)[i], g.px(line)});
    svg.polyline(lines.back().px, "distance-line");
  }
  return lines;
}

}  // namespace gearwright
