#include "gearwright/figure/designs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/figure/ticks.hpp"

namespace gearwright {

namespace {

constexpr double kFree =
    0.06;  // margin at each end of an axis, relative to the range of the values
// If all values are positive and the greatest is more than this many times the least, the axis is
// logarithmic, because a linear axis would crowd the dots at one end.
constexpr double kWideSpan = 15.0;
// If the values of an axis differ by at most the relative difference kOneValue, they count as
// one value, and the axis gets the relative margin kRoomOfOne around it.
constexpr double kOneValue = 1e-6;
constexpr double kRoomOfOne = 0.01;

// Returns the axis with a range that contains the values. For an objective, the unit is followed by
// words that state which values are better.
FigureAxis fitted(DesignAxis of, double lo, double hi) {
  FigureAxis axis = std::move(of.axis);
  if (of.better != Better::none)
    axis.unit += fmt::format("{}{} values are better", axis.unit.empty() ? "" : ", ",
                             of.better == Better::greater ? "greater" : "smaller");
  const double size = std::max({std::abs(lo), std::abs(hi), 1e-3});
  if (hi - lo < kOneValue * size) {
    lo -= kRoomOfOne * size;
    hi += kRoomOfOne * size;
  }
  axis.log = lo > 0.0 && hi > kWideSpan * lo;
  const auto wide =
      axis.log ? widened(std::log10(lo), std::log10(hi), kFree) : widened(lo, hi, kFree);
  axis.lo = axis.log ? std::pow(10.0, wide[0]) : wide[0];
  axis.hi = axis.log ? std::pow(10.0, wide[1]) : wide[1];
  return axis;
}

bool of_front(const DesignDot& dot) { return dot.style.starts_with("dot-front"); }

}  // namespace

std::vector<Vec2> staircase(const std::vector<Vec2>& points, const std::array<bool, 2>& greater) {
  // The objectives are converted to costs. Lower costs are better.
  const Vec2 sign(greater[0] ? -1.0 : 1.0, greater[1] ? -1.0 : 1.0);
  std::vector<Vec2> costs;
  for (const Vec2& p : points) costs.push_back(p.cwiseProduct(sign));
  std::sort(costs.begin(), costs.end(), [](const Vec2& a, const Vec2& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  std::vector<Vec2> corners;
  for (const Vec2& c : costs) {
    if (corners.empty()) {
      corners.push_back(c);
    } else if (c.y() < corners.back().y()) {
      corners.push_back({c.x(), corners.back().y()});
      corners.push_back(c);
    }
  }
  for (Vec2& c : corners) c = c.cwiseProduct(sign);
  return corners;
}

Figure designs_figure(DesignAxis x, DesignAxis y, const std::vector<DesignDot>& dots) {
  GW_EXPECTS(!dots.empty());
  Bounds box;
  std::vector<Vec2> front;
  for (const DesignDot& dot : dots) {
    box.cover(dot.at);
    if (of_front(dot)) front.push_back(dot.at);
  }
  Figure f{
      "designs-plot",
      fmt::format("Designs by {} and {}", x.axis.words, y.axis.words),
      fmt::format(
          "{} designs as dots, with the {} on the horizontal axis and the {} on the vertical axis.",
          dots.size(), x.axis.words, y.axis.words),
      "",
      fitted(x, box.lo.x(), box.hi.x()),
      fitted(y, box.lo.y(), box.hi.y())};
  f.tall = 0.7;
  if (front.size() > 1 && x.better != Better::none && y.better != Better::none)
    f.line(staircase(front, {x.better == Better::greater, y.better == Better::greater}),
           "staircase");
  for (const DesignDot& dot : dots)
    f.dot(dot.at, of_front(dot) ? 4.5 : 3.2, dot.style,
          fmt::format("{}; {} {:.6g}, {} {:.6g}", dot.words, f.x.words, dot.at.x(), f.y.words,
                      dot.at.y()));
  return f;
}

}  // namespace gearwright
