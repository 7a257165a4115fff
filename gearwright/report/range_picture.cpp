#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "gearwright/report/crossed_figures.hpp"
#include "gearwright/report/crossed_range.hpp"
#include "gearwright/report/html_text.hpp"

namespace gearwright {

namespace {

constexpr double kPanel = 124.0, kGap = 34.0;  // px, height of a panel and from one to the next
constexpr PlotArea kArea{640, 66, 18, 58, 3 * kPanel + 2 * kGap, kGap + 20};
constexpr double kNear = 12.0;  // px, a label's height

// One of the three quantities: on the curve, and of the pair as mounted.
struct Quantity {
  std::string words;  // SVG markup
  std::function<double(const CrossedSample&)> value;
  double mounted;
  int digits;
};

std::vector<Quantity> quantities(const InvolutePair& pair) {
  return {
      {"centre distance " + symbol_svg("a") + ", mm",
       [](const CrossedSample& s) { return s.place.center_distance; }, pair.center_distance, 4},
      {"shaft angle " + symbol_svg("Σ") + ", °",
       [](const CrossedSample& s) { return s.place.shaft_angle.deg(); }, pair.shaft_angle.deg(), 4},
      {"contact ratio " + symbol_svg("ε") + ", tip to tip",
       [](const CrossedSample& s) { return s.contact_ratio; }, pair.contact_ratio(), 3}};
}

// What a panel shows: the curve where ε ≥ 1, elsewhere only what lies in between, and the mounted
// pair.
std::array<double, 2> shown(const InvolutePair& pair, const std::vector<CrossedSample>& samples,
                            const Quantity& q) {
  double lo = q.mounted;
  double hi = q.mounted;
  for (const CrossedSample& s : samples) {
    if (pair.contact_ratio_range && s.contact_ratio < 1.0) continue;
    lo = std::min(lo, q.value(s));
    hi = std::max(hi, q.value(s));
  }
  const auto ends = widened(lo, hi, 0.12);
  return {ends[0], ends[1]};
}

// Of the curve where the pair is mounted, px up per px to the right.
double slope(const InvolutePair& pair, const Quantity& q, const Axis& x, const Axis& y) {
  const Angle at = Angle::radians(pair.mesh.rack.normal_pressure_angle);
  const Angle step = Angle::degrees(0.01 * (x.hi - x.lo));
  const auto before = crossed_sample(pair, at - step);
  const auto after = crossed_sample(pair, at + step);
  if (!before || !after) return 0.0;
  return (y(q.value(*before)) - y(q.value(*after))) / (x(2 * step.deg()) - x(0.0));
}

void draw_panel(Svg& svg, const InvolutePair& pair, const std::vector<CrossedSample>& samples,
                const Quantity& q, const Axis& x, double top) {
  const auto [lo, hi] = shown(pair, samples, q);
  const Axis y{lo, hi, top + kPanel, top};
  draw_rows(svg, x, y, 6);
  svg.text({x.from, top == kArea.top ? top - 36 : top - 7}, q.words, Anchor::start, "panel");
  svg.begin_clip(x.from, top, x.to - x.from, kPanel);
  draw_curve(svg, x, y, over_angle(samples, q.value), "curve ink");
  svg.end_group();
  const auto mark = [&](Angle angle, const char* style, double radius) {
    const auto s = crossed_sample(pair, angle);
    const Vec2 at(x(angle.deg()), s ? y(q.value(*s)) : -1e9);
    if (s && at.x() > x.from && at.x() < x.to && at.y() > top && at.y() < top + kPanel)
      svg.dot(at, radius, style);
  };
  for (const Approximation& a : approximations(pair))
    mark(a.normal_pressure_angle, "mark ring", 4.0);
  if (pair.min_distance) mark(pair.min_distance->normal_pressure_angle, "mark", 3.4);
  const Angle mounted = Angle::radians(pair.mesh.rack.normal_pressure_angle);
  const Vec2 here(x(mounted.deg()), y(q.mounted));
  svg.dot(here, 3.4, "mark action-dot");
  const bool left = here.x() > (x.from + x.to) / 2;
  // Beside the curve, not on it: below where it rises away on the label's side.
  const double rise = slope(pair, q, x, y);
  const auto on_curve = crossed_sample(pair, mounted);
  const bool on = on_curve && std::abs(y(q.value(*on_curve)) - here.y()) < kNear;
  const bool high = on && std::abs(rise) > 0.1 ? left == (rise > 0.0) : here.y() > top + kPanel / 2;
  svg.text(here, fixed(q.mounted, q.digits), left ? Anchor::end : Anchor::start, "halo here",
           {left ? -9.0 : 9.0, high ? -9.0 : 17.0});
}

std::string range_svg(const InvolutePair& pair) {
  const std::vector<CrossedSample> samples = crossed_samples(pair);
  const Axis x = angle_axis(samples, kArea);
  Svg svg("range", kArea.width, kArea.height(), "Places that the pair can take",
          "Centre distance, shaft angle and contact ratio of the pair free of backlash, each over "
          "the normal pressure angle of the common rack; shaded where the contact ratio is at "
          "least 1, with lines at the least centre distance and where the pair is mounted.");
  draw_angles(svg, pair, x, kArea);
  double top = kArea.top;
  for (const Quantity& q : quantities(pair)) {
    draw_panel(svg, pair, samples, q, x, top);
    top += kPanel + kGap;
  }
  return svg.str();
}

}  // namespace

std::string range_figure(const InvolutePair& pair) {
  const bool by_hand = !approximations(pair).empty();
  return captioned(
      range_svg(pair),
      fmt::format(
          "<strong>Places that the pair can take</strong> free of backlash. {} {} {}{}",
          caption_key("action", "as mounted"), caption_key("ink", "least centre distance"),
          pair.contact_ratio_range ? "Shaded: the contact ratio is at least 1."
                                   : "The contact ratio reaches 1 nowhere.",
          by_hand ? " Hollow dots: approximate solutions of the least centre distance." : ""));
}

}  // namespace gearwright
