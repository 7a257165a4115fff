#include "gearwright/report/plot_axis.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/report/html_text.hpp"

namespace gearwright {

double Axis::near(double v) const {
  const double length = std::abs(to - from);
  return std::clamp((*this)(v), std::min(from, to) - length, std::max(from, to) + length);
}

Ticks round_ticks(double lo, double hi, int most) {
  GW_EXPECTS(lo < hi && most >= 1);
  const double rough = (hi - lo) / most;
  double power = std::floor(std::log10(rough));
  double step = std::pow(10.0, power);
  for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
    // 1e-9: a step that fits but for rounding fits.
    if (factor * std::pow(10.0, power) < rough * (1 - 1e-9)) continue;
    step = factor * std::pow(10.0, power);
    if (factor == 10.0) power += 1;
    break;
  }
  Ticks ticks{{}, std::max(0, static_cast<int>(-power))};
  const double first = std::ceil(lo / step - 1e-9);
  const double last = std::floor(hi / step + 1e-9);
  for (double k = first; k <= last; k += 1) ticks.values.push_back(k * step);
  return ticks;
}

std::vector<double> levels_between(double lo, double hi, int most) {
  std::vector<double> levels = round_ticks(lo, hi, most).values;
  std::erase_if(levels, [&](double v) { return v <= lo || v >= hi; });
  return levels;
}

std::vector<double> widened(double lo, double hi, double share) {
  const double least = 1e-9 * std::max({std::abs(lo), std::abs(hi), 1e-9});
  const double by = std::max(share * (hi - lo), least);
  return {lo - by, hi + by};
}

void draw_rows(Svg& svg, const Axis& x, const Axis& y, int most) {
  const Ticks ticks = round_ticks(y.lo, y.hi, most);
  for (const double v : ticks.values) {
    svg.line({x.from, y(v)}, {x.to, y(v)}, v == 0.0 ? "axis" : "grid");
    svg.text({x.from - 6, y(v) + 4}, fixed(v, ticks.decimals), Anchor::end, "tick");
  }
  svg.line({x.from, y.from}, {x.to, y.from}, "axis");
}

void draw_foot(Svg& svg, const Axis& x, double top, double bottom, int most,
               std::string_view words) {
  const Ticks ticks = round_ticks(x.lo, x.hi, most);
  for (const double v : ticks.values) {
    svg.line({x(v), top}, {x(v), bottom + 4}, "grid");
    svg.text({x(v), bottom + 17}, fixed(v, ticks.decimals), Anchor::middle, "tick");
  }
  svg.text({(x.from + x.to) / 2, bottom + 36}, words, Anchor::middle, "tick");
}

void draw_curve(Svg& svg, const Axis& x, const Axis& y, const std::vector<Vec2>& values,
                std::string_view style) {
  std::vector<Vec2> points;
  const auto draw = [&] {
    if (points.size() > 1) svg.polyline(points, style);
    points.clear();
  };
  for (const Vec2& v : values) {
    if (std::isfinite(v.x()) && std::isfinite(v.y()))
      points.push_back({x.near(v.x()), y.near(v.y())});
    else
      draw();
  }
  draw();
}

std::string curves_svg(const PlotWords& words, const std::vector<PlotCurve>& curves,
                       bool from_zero) {
  Vec2 lo = Vec2::Constant(kInfinity);
  Vec2 hi = -lo;
  for (const PlotCurve& c : curves) {
    for (const Vec2& v : c.values) {
      lo = {std::min(lo.x(), v.x()), std::isfinite(v.y()) ? std::min(lo.y(), v.y()) : lo.y()};
      hi = {std::max(hi.x(), v.x()), std::isfinite(v.y()) ? std::max(hi.y(), v.y()) : hi.y()};
    }
  }
  if (!(lo.x() < hi.x() && lo.y() <= hi.y())) return {};
  const double least = from_zero ? 0.0 : lo.y();
  const std::vector<double> range = widened(least, hi.y(), 0.06);
  constexpr PlotArea kArea{640, 74, 26, 44, 240, 50};
  const Axis x = kArea.across(lo.x(), hi.x());
  const Axis y = kArea.up(from_zero ? 0.0 : range[0], range[1]);
  Svg svg(words.id, kArea.width, kArea.height(), words.title, words.description);
  svg.text({12, 20}, words.up, Anchor::start, "panel");
  draw_foot(svg, x, kArea.top, kArea.bottom(), 8, words.along);
  draw_rows(svg, x, y, 5);
  svg.begin_clip(x.from - 5, kArea.top, x.to - x.from + 10, kArea.tall + 5);
  for (const PlotCurve& c : curves) {
    draw_curve(svg, x, y, c.values, c.style);
    if (!c.dots) continue;
    for (const Vec2& v : c.values)
      if (std::isfinite(v.y())) svg.dot({x(v.x()), y(v.y())}, 3.0, "mark");
  }
  svg.end_group();
  return svg.str();
}

}  // namespace gearwright
