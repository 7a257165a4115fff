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
// If the greatest value is more than this many times the least value, the axis is logarithmic,
// because a linear axis would crowd the dots at one end.
constexpr double kWideSpan = 15.0;
// If the values of an axis differ by at most the relative difference kOneValue, they count as
// one value, and the axis gets the relative margin kRoomOfOne around it.
constexpr double kOneValue = 1e-6;
constexpr double kRoomOfOne = 0.01;

void fit(FigureAxis& axis, double lo, double hi) {
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
}

}  // namespace

Figure designs_figure(FigureAxis x, FigureAxis y, const std::vector<DesignDot>& dots,
                      std::vector<Vec2> border) {
  GW_EXPECTS(!dots.empty());
  Bounds box;
  for (const DesignDot& dot : dots) box.cover(dot.at);
  fit(x, box.lo.x(), box.hi.x());
  fit(y, box.lo.y(), box.hi.y());
  Figure f{
      "designs-plot",
      fmt::format("Designs by {} and {}", x.words, y.words),
      fmt::format(
          "{} designs as dots, with the {} on the horizontal axis and the {} on the vertical axis.",
          dots.size(), x.words, y.words),
      "",
      std::move(x),
      std::move(y)};
  f.tall = 0.7;
  if (border.size() > 1) f.line(std::move(border), "staircase");
  for (const DesignDot& dot : dots)
    f.dot(dot.at, dot.style.starts_with("dot-front") ? 4.5 : 3.2, dot.style,
          fmt::format("{}; {} {:.6g}, {} {:.6g}", dot.words, f.x.words, dot.at.x(), f.y.words,
                      dot.at.y()));
  return f;
}

}  // namespace gearwright
