#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/figure_units.hpp"
#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/figure/ticks.hpp"
#include "gearwright/report/crossed_figures.hpp"
#include "gearwright/report/crossed_range.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/line_marks.hpp"

namespace gearwright {

namespace {

// One of the three quantities, with its curve and its value for the mounted pair.
struct RangeCurve {
  const char* id;
  FigureAxis axis;
  std::function<double(const CrossedSample&)> value;
  double mounted;
  int digits;
};

std::vector<RangeCurve> quantities(const CrossedPair& pair) {
  return {{"range-distance",
           {.words = "centre distance", .unit = "mm", .symbol = "a"},
           [](const CrossedSample& s) { return s.place.center_distance; },
           pair.center_distance,
           4},
          {"range-angle",
           {.words = "shaft angle", .unit = "°", .symbol = "Σ"},
           [](const CrossedSample& s) { return s.place.shaft_angle.deg(); },
           pair.shaft_angle.deg(),
           4},
          {"range-ratio",
           {.words = "contact ratio from tip to tip", .unit = {}, .symbol = "ε"},
           [](const CrossedSample& s) { return s.contact_ratio; },
           pair.contact_ratio(),
           3}};
}

// Returns the range of the axis of a panel. It contains the values on the curve and that of the
// mounted pair. If the contact ratio reaches 1 anywhere, only the part of the curve with ε ≥ 1
// counts.
std::vector<double> shown(const CrossedPair& pair, const std::vector<CrossedSample>& samples,
                          const RangeCurve& q) {
  double lo = q.mounted;
  double hi = q.mounted;
  for (const CrossedSample& s : samples) {
    if (pair.contact_ratio_range && s.contact_ratio < 1.0) continue;
    lo = std::min(lo, q.value(s));
    hi = std::max(hi, q.value(s));
  }
  return widened(lo, hi, 0.12);
}

Figure range_panel(const CrossedPair& pair, const std::vector<CrossedSample>& samples,
                   const RangeCurve& q) {
  Figure f{q.id,
           "Possible positions of the pair: " + q.axis.words,
           "The " + q.axis.words +
               " of the pair without backlash, over the normal pressure angle of the common rack. "
               "In the shaded range the contact ratio is at least 1. Lines mark the least centre "
               "distance and the pair as mounted.",
           "",
           {},
           q.axis};
  const std::vector<double> ends = shown(pair, samples, q);
  f.y.lo = ends[0];
  f.y.hi = ends[1];
  f.tall = 0.24;
  add_angles(f, pair, samples);
  f.line(over_angle(samples, q.value), "curve ink", q.axis.words);
  const auto mark = [&](Angle angle, double radius, const char* style, const char* words) {
    const auto s = crossed_sample(pair, angle);
    if (!s) return;
    const Vec2 at(angle.deg(), q.value(*s));
    if (at.x() > f.x.lo && at.x() < f.x.hi && at.y() > ends[0] && at.y() < ends[1])
      f.dot(at, radius, style, words);
  };
  for (const Approximation& a : approximations(pair))
    mark(a.normal_pressure_angle, 4.0, "mark ring", a.name);
  if (pair.min_distance)
    mark(pair.min_distance->normal_pressure_angle, 3.4, "mark", "least centre distance");
  const Angle mounted = Angle::radians(pair.mesh.rack.normal_pressure_angle);
  f.point({mounted.deg(), q.mounted}, 3.4, "mark action-dot", "", {9.0, -9.0});
  f.marks.back().length = {q.mounted, q.digits, q.axis.unit};
  f.marks.back().label_style = "halo here";
  return f;
}

constexpr int kZoomSteps = 80;
// If the solutions differ by less than this value, in µm, no figure is drawn. The rounding error of
// centre distances is 1e-11 µm.
constexpr double kWorthShowing = 1e-6;

constexpr double kSameAngle = 1e-9;  // rad, 0.0002″; difference of angles that count as equal

// Returns the centre distance at the angle α_wn (degrees) minus the least centre distance, µm.
double above_min(const CrossedPair& pair, double degrees) {
  const auto s = crossed_sample(pair, Angle::degrees(degrees));
  return s ? kUmPerMm * (s->place.center_distance - pair.min_distance->center_distance) : 0.0;
}

std::optional<Figure> zoom_figure(const CrossedPair& pair, const std::vector<Approximation>& all) {
  const double exact = pair.min_distance->normal_pressure_angle.deg();
  std::vector<LetterAt> letters{{"0", Vec2(exact, 0.0)}};
  for (const Approximation& a : all) {
    const double degrees = a.normal_pressure_angle.deg();
    letters.push_back({a.letter, Vec2(degrees, above_min(pair, degrees))});
  }
  Bounds box;
  for (const LetterAt& l : letters) box.cover(l.at);
  const double most = box.hi.y();
  if (most < kWorthShowing) return std::nullopt;
  const double reach = std::max(box.size().x(), 1e-9);
  Figure f{
      "least",
      "Approximations of the least centre distance",
      "The curve shows how much the centre distance exceeds its least value at each normal "
      "pressure angle of the common rack. Marks show the exact and the approximate solutions.",
      ". Mark 0 is the exact solution. Marks 1 to 3 are the series with one to three terms, v is "
      "the virtual spur pair, and v′ is the corrected virtual spur pair. The curve is the exact "
      "centre distance at each angle. Near its least value, the centre distance hardly changes.",
      angle_axis(box.lo.x() - 0.12 * reach, box.hi.x() + 0.12 * reach),
      {.words = "excess over the least centre distance",
       .unit = "µm",
       .lo = -0.06 * most,
       .hi = 1.25 * most,
       .symbol = "a"}};
  f.tall = 0.3;
  std::vector<Vec2> curve;
  for (int k = 0; k <= kZoomSteps; ++k) {
    const double v = f.x.lo + k * (f.x.hi - f.x.lo) / kZoomSteps;
    if (crossed_sample(pair, Angle::degrees(v))) curve.push_back({v, above_min(pair, v)});
  }
  f.line(std::move(curve), "curve ink", "excess");
  add_letters(f, letters);
  for (const LetterAt& l : letters)
    f.dot(l.at, &l == &letters.front() ? 3.4 : 4.0, &l == &letters.front() ? "mark" : "mark ring");
  return f;
}

std::vector<std::string> table_row(const CrossedPair& pair, const std::string& name, Angle angle,
                                   UnitSystem units) {
  const auto s = crossed_sample(pair, angle);
  GW_EXPECTS(s.has_value());  // a rack exists for every given angle
  const double off = s->place.center_distance - pair.min_distance->center_distance;
  const double seconds = kArcsecPerDeg * (angle - pair.min_distance->normal_pressure_angle).deg();
  return {escaped(name),
          fixed(angle.deg(), kAngleDigits),
          fixed(seconds, 1),
          fixed(s->place.shaft_angle.deg(), kAngleDigits),
          text_in(units, Unit::mm, s->place.center_distance, kLengthDigits),
          text_in(units, Unit::um, kUmPerMm * off, 4)};
}

}  // namespace

std::string range_figure(const CrossedPair& pair, UnitSystem units) {
  const bool by_hand = !approximations(pair).empty();
  const std::vector<CrossedSample> samples = crossed_samples(pair);
  std::string panels;
  for (const RangeCurve& q : quantities(pair))
    panels += figure_svg(in_units(units, range_panel(pair, samples, q)), kWideFigure);
  return captioned(
      panels,
      fmt::format(
          "<strong>Possible positions of the pair</strong> without backlash. {} {} {}{}",
          caption_key("action", "as mounted"), caption_key("ink", "least centre distance"),
          pair.side() < 0.0          ? ""
          : pair.contact_ratio_range ? "In the shaded range the contact ratio is at least 1."
                                     : "The contact ratio is below 1 everywhere.",
          by_hand ? " Hollow dots are approximate solutions for the least centre distance." : ""));
}

std::string min_distance_figure(const CrossedPair& pair, UnitSystem units) {
  const std::vector<Approximation> all = approximations(pair);
  const auto figure = all.empty() ? std::nullopt : zoom_figure(pair, all);
  return figure ? figure_html(in_units(units, *figure), kWideFigure) : std::string();
}

std::string min_distance_table(const CrossedPair& pair, UnitSystem units) {
  const std::vector<Approximation> all = approximations(pair);
  if (all.empty()) return {};
  const Angle exact = pair.min_distance->normal_pressure_angle;
  const bool one = std::all_of(all.begin(), all.end(), [&](const Approximation& a) {
    return abs(a.normal_pressure_angle - exact).rad() < kSameAngle;
  });
  if (one) {
    return "<p>The profile shifts of the teeth as cut add up to zero, so the least centre distance "
           "is the reference centre distance, and every approximation gives this value.</p>\n";
  }
  std::vector<std::vector<std::string>> rows{table_row(pair, "Exact", exact, units)};
  for (const Approximation& a : all)
    rows.push_back(table_row(pair, a.name, a.normal_pressure_angle, units));
  const std::string alpha = symbol_html("α_wn"), a = symbol_html("a");
  return value_table("Least centre distance, exact and approximate",
                     {"Solution", alpha + ", °", "Δ" + alpha + ", ″", symbol_html("Σ") + ", °",
                      fmt::format("{}, {}", a, unit_text(units, Unit::mm)),
                      fmt::format("Δ{}, {}", a, unit_text(units, Unit::um))},
                     rows);
}

std::string min_distance_part(const CrossedPair& pair, UnitSystem units) {
  const std::string table = min_distance_table(pair, units);
  const std::string figure = min_distance_figure(pair, units);
  if (figure.empty()) return table;
  return "<details><summary>Approximations of the least centre distance</summary>\n" +
         in_columns(table, figure) + "</details>\n";
}

}  // namespace gearwright
