#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/report/crossed_figures.hpp"
#include "gearwright/report/crossed_range.hpp"
#include "gearwright/report/html_text.hpp"

namespace gearwright {

namespace {

constexpr PlotArea kArea{640, 70, 18, 54, 150, 50};
constexpr int kSteps = 80;
// µm. What the solutions differ by; centre distances carry 1e-11 µm of rounding.
constexpr double kWorthShowing = 1e-6;

constexpr double kSameAngle = 1e-9;  // rad, 0.0002″

// µm of centre distance at α_wn (degrees) above the least.
double above_min(const InvolutePair& pair, double degrees) {
  const auto s = crossed_sample(pair, Angle::degrees(degrees));
  return s ? kUmPerMm * (s->place.center_distance - pair.min_distance->center_distance) : 0.0;
}

std::string zoom_svg(const InvolutePair& pair, const std::vector<Approximation>& all) {
  const double exact = pair.min_distance->normal_pressure_angle.deg();
  std::vector<double> angles{exact};
  for (const Approximation& a : all) angles.push_back(a.normal_pressure_angle.deg());
  const auto [least, greatest] = std::minmax_element(angles.begin(), angles.end());
  const double reach = std::max(*greatest - *least, 1e-9);
  const Axis x = kArea.across(*least - 0.12 * reach, *greatest + 0.12 * reach);
  double most = 0.0;
  std::vector<Vec2> curve;
  for (int k = 0; k <= kSteps; ++k) {
    const double v = x.lo + k * (x.hi - x.lo) / kSteps;
    if (!crossed_sample(pair, Angle::degrees(v))) continue;
    curve.push_back({v, above_min(pair, v)});
  }
  for (const double a : angles) most = std::max(most, above_min(pair, a));
  if (most < kWorthShowing) return {};
  const Axis y = kArea.up(-0.06 * most, 1.25 * most);
  Svg svg("least", kArea.width, kArea.height(), "The least centre distance and its approximations",
          "Centre distance above the least one over the normal pressure angle of the common rack, "
          "near the least centre distance; marks at the exact and the approximate solutions.");
  draw_foot(svg, x, kArea.top, kArea.bottom(), 6, angle_words());
  draw_rows(svg, x, y, 4);
  svg.text({x.from, kArea.top - 37}, symbol_svg("a") + " above the least, µm", Anchor::start,
           "panel");
  svg.begin_clip(x.from, kArea.top, x.to - x.from, kArea.tall);
  draw_curve(svg, x, y, curve, "curve ink");
  svg.end_group();
  std::vector<double> wanted;
  for (const double a : angles) wanted.push_back(x(a));
  const std::vector<double> placed = spread(wanted, 20.0, x.from + 8, x.to - 8);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const Vec2 at(wanted[i], y(above_min(pair, angles[i])));
    svg.polyline({{placed[i], kArea.top - 4}, {wanted[i], kArea.top + 9}, at}, "leader");
    svg.text({placed[i], kArea.top - 9}, i == 0 ? "0" : all[i - 1].letter, Anchor::middle,
             "letter");
    svg.dot(at, i == 0 ? 3.4 : 4.0, i == 0 ? "mark" : "mark ring");
  }
  return svg.str();
}

std::vector<std::string> table_row(const InvolutePair& pair, const std::string& name, Angle angle) {
  const auto s = crossed_sample(pair, angle);
  GW_EXPECTS(s.has_value());  // of approximations(), or the exact one
  const double off = s->place.center_distance - pair.min_distance->center_distance;
  const double seconds = kArcsecPerDeg * (angle - pair.min_distance->normal_pressure_angle).deg();
  return {escaped(name),
          fixed(angle.deg(), kAngleDigits),
          fixed(seconds, 1),
          fixed(s->place.shaft_angle.deg(), kAngleDigits),
          fixed(s->place.center_distance, kLengthDigits),
          fixed(kUmPerMm * off, 4)};
}

}  // namespace

std::string min_distance_figure(const InvolutePair& pair) {
  GW_EXPECTS(pair.crossed());
  const std::vector<Approximation> all = approximations(pair);
  const std::string zoom = all.empty() ? std::string() : zoom_svg(pair, all);
  if (zoom.empty()) return {};
  return captioned(
      zoom,
      "<strong>The least centre distance, approximately</strong>: 0 exact, 1 to 3 terms of the "
      "series, v the virtual spur pair, v′ the same corrected. The curve is the exact distance at "
      "each angle: near its least it hardly changes.");
}

std::string min_distance_table(const InvolutePair& pair) {
  GW_EXPECTS(pair.crossed());
  const std::vector<Approximation> all = approximations(pair);
  if (all.empty()) return {};
  const Angle exact = pair.min_distance->normal_pressure_angle;
  const bool one = std::all_of(all.begin(), all.end(), [&](const Approximation& a) {
    return abs(a.normal_pressure_angle - exact).rad() < kSameAngle;
  });
  if (one) {
    return "<p>The profile shifts of the teeth as cut add up to zero: the least centre distance is "
           "that of the reference cylinders, and every approximation agrees.</p>\n";
  }
  std::vector<std::vector<std::string>> rows{table_row(pair, "Exact", exact)};
  for (const Approximation& a : all)
    rows.push_back(table_row(pair, a.name, a.normal_pressure_angle));
  const std::string alpha = symbol_html("α_wn"), a = symbol_html("a");
  return value_table("Least centre distance, exact and by approximation",
                     {"Solution", alpha + ", °", "Δ" + alpha + ", ″", symbol_html("Σ") + ", °",
                      a + ", mm", "Δ" + a + ", µm"},
                     rows);
}

std::string min_distance_part(const InvolutePair& pair) {
  const std::string table = min_distance_table(pair);
  const std::string figure = min_distance_figure(pair);
  if (figure.empty()) return table;
  return "<details><summary>The least centre distance, by approximation</summary>\n" +
         in_columns(table, figure) + "</details>\n";
}

}  // namespace gearwright
