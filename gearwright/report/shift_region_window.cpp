#include "gearwright/report/shift_region_window.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/math/root.hpp"

namespace gearwright {

namespace {

constexpr double kPadding = 0.17;      // of the rectangle around it
constexpr double kZoomPadding = 0.42;  // of a region: room for its labels
constexpr double kMinWindow = 1e-3;    // modules: a hundredth of what a cutter can be set to

}  // namespace

void ShiftBox::hold(const Vec2& p) {
  lo = lo.cwiseMin(p);
  hi = hi.cwiseMax(p);
}

ShiftBox limits_box(const ShiftGraph& graph) {
  const auto& [g_1, g_2] = graph.gears();
  return {{g_1.x_min, g_2.x_min}, {g_1.x_max, g_2.x_max}};
}

RegionWindow region_window(const ShiftBox& limits, const ShiftBox& region, double aspect,
                           double fair_part) {
  const bool zoomed = region.size().maxCoeff() < fair_part * limits.size().maxCoeff();
  ShiftBox box = region;
  double pad = kZoomPadding * std::max(region.size().maxCoeff(), kMinWindow);
  if (!zoomed) {
    box.hold(limits.lo);
    box.hold(limits.hi);
    pad = kPadding * std::max(box.size().maxCoeff(), kMinWindow);
  }
  const Vec2 size = box.size() + 2 * Vec2(pad, pad);
  const double height = std::max(size.y(), size.x() / aspect);
  const Vec2 half(aspect * height / 2, height / 2);
  const Vec2 middle = (box.lo + box.hi) / 2;
  return {{middle - half, middle + half}, zoomed};
}

std::optional<double> sum_at_distance(const ShiftGraph& graph, double a, const ShiftBox& window) {
  const double module = graph.trial().module;
  const double lo = window.lo.sum();
  const double hi = window.hi.sum();
  if (!(lo < hi)) return std::nullopt;
  const auto more = [&](double sum) { return module * std::abs(graph.place(sum).a) - a; };
  const Root root = find_root(more, lo, hi);
  return root.found() ? std::optional(root.x) : std::nullopt;
}

}  // namespace gearwright
