#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "gearwright/base/units.hpp"
#include "gearwright/design/shift_charts.hpp"
#include "gearwright/report/free_labels.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/plot_axis.hpp"
#include "gearwright/report/search_figures.hpp"

namespace gearwright {

namespace {

constexpr PlotArea kArea{640, 62, 18, 40, 360, 52};
constexpr double kTop = kArea.top, kBottom = kArea.bottom();
constexpr double kNames = 98.0;  // px more at the right, for names at the ends of curves
constexpr std::array<int, 11> kTeethTicks{7, 8, 10, 12, 15, 20, 25, 30, 40, 60, 100};
constexpr double kSoundContactRatio = 1.2;  // the usual least contact ratio of spur gears

const std::array<const char*, 3> kTipNames{"pointed", "tip 0.2", "tip 0.4"};

double place_of(double teeth) { return std::log(teeth); }

Axis teeth_axis(double right) {
  return {place_of(kChartMin), place_of(kChartMax), kArea.left, kArea.width - right};
}

void draw_teeth(Svg& svg, const Axis& x) {
  for (const int z : kTeethTicks) {
    const double at = x(place_of(z));
    svg.line({at, kTop}, {at, kBottom + 4}, "grid");
    svg.text({at, kBottom + 17}, std::to_string(z), Anchor::middle, "tick");
  }
  svg.text({(x.from + x.to) / 2, kBottom + 38}, "number of teeth " + symbol_svg("z"),
           Anchor::middle, "tick");
}

struct ChartLine {
  std::vector<Vec2> points;  // (log z, value)
  std::string name, style;
};

// Names at the right end, each at the height at which its curve leaves the plot.
void name_curves(Svg& svg, const Axis& x, const Axis& y, const std::vector<ChartLine>& curves) {
  std::vector<double> wanted;
  for (const ChartLine& c : curves)
    wanted.push_back(std::clamp(y(c.points.back().y()), kTop + 6, kBottom - 6));
  const std::vector<double> placed = spread(wanted, 19.0, kTop + 4, kBottom - 4);
  for (std::size_t i = 0; i < curves.size(); ++i)
    svg.text({x.to, placed[i]}, curves[i].name, Anchor::start, "halo " + curves[i].style,
             {8.0, 5.0});
}

void draw_curves(Svg& svg, const Axis& x, const Axis& y, const std::vector<ChartLine>& curves) {
  svg.begin_clip(x.from, kTop, x.to - x.from, kArea.tall);
  for (const ChartLine& c : curves) draw_curve(svg, x, y, c.points, "curve " + c.style);
  svg.end_group();
}

std::vector<Vec2> in_px(const Axis& x, const Axis& y, const ChartLine& c) {
  std::vector<Vec2> px;
  for (const Vec2& p : c.points) px.push_back({x(p.x()), y.near(p.y())});
  return px;
}

// The name beside the last visible part of a curve that leaves the plot above or below.
void name_on_curve(Svg& svg, FreeLabels& labels, const std::vector<Vec2>& px, const ChartLine& c) {
  std::vector<LabelPlace> places;
  for (auto p = px.rbegin(); p != px.rend(); ++p) {
    if (p->y() < kTop + 14 || p->y() > kBottom - 14) continue;
    places.push_back({*p, {12, 0}, Anchor::start});
    places.push_back({*p, {-12, 0}, Anchor::end});
  }
  labels.draw(svg, c.name, c.name, "halo " + c.style, places, FreeLabels::If::always);
}

// What the problem leaves, as polygons: one for each run of tooth numbers with a shift at all.
void draw_room(Svg& svg, const Axis& x, const Axis& y, const std::vector<ShiftLimits>& chart) {
  svg.begin_clip(x.from, kTop, x.to - x.from, kArea.tall);
  std::vector<Vec2> below;
  std::vector<Vec2> above;
  const auto flush = [&] {
    if (below.size() > 1) {
      std::vector<Vec2> outline = below;
      outline.insert(outline.end(), above.rbegin(), above.rend());
      svg.polygon(outline, "room");
    }
    below.clear();
    above.clear();
  };
  for (const ShiftLimits& row : chart) {
    if (row.min > row.max) {
      flush();
      continue;
    }
    below.push_back({x(place_of(row.teeth)), y.near(row.min)});
    above.push_back({x(place_of(row.teeth)), y.near(row.max)});
  }
  flush();
  svg.end_group();
}

std::string helix_words(const Trial& trial) {
  if (trial.helix[0] == Angle()) return "";
  return fmt::format(", helix angle {:.6g}°", abs(trial.helix[0]).deg());
}

bool on_chart(int teeth) { return teeth >= kChartMin && teeth <= kChartMax; }

}  // namespace

std::string shift_limits_figure(const SearchProblem& problem, const Trial& trial,
                                const DesignRow* design) {
  const auto chart =
      shift_limit_chart(problem, trial.rack, trial.helix[0], 0, kChartMin, kChartMax);
  std::vector<ChartLine> curves{{{}, "undercut", "limit-undercut"}};
  for (const char* name : kTipNames) curves.push_back({{}, name, "limit-tip"});
  curves[1].style += " dot";
  curves[3].style += " dash";
  double lowest = 0.0;
  double highest = 1.0;
  for (const ShiftLimits& row : chart) {
    curves[0].points.push_back({place_of(row.teeth), row.undercut});
    for (std::size_t i = 0; i < kChartTips.size(); ++i)
      curves[i + 1].points.push_back({place_of(row.teeth), row.tip[i]});
    if (row.min > row.max) continue;
    lowest = std::min(lowest, row.min);
    highest = std::max(highest, row.max);
  }
  const Axis x = teeth_axis(kArea.right);
  const Axis y =
      kArea.up(std::max(lowest, -2.0) - 0.35, std::min(std::max(highest, 1.4), 3.0) + 0.25);
  Svg svg("chart-limits", kArea.width, kArea.height(), "Limits of the profile shift",
          "Over the number of teeth: the shift below which gears are undercut, and the shifts at "
          "which tips are pointed, 0.2 and 0.4 modules thick.");
  svg.text({12, 22}, "profile shift " + symbol_svg("x") + ", modules", Anchor::start, "panel");
  draw_teeth(svg, x);
  draw_rows(svg, x, y, 8);
  draw_room(svg, x, y, chart);
  draw_curves(svg, x, y, curves);

  FreeLabels labels({x.from + 2, kTop + 2, x.to - 2, kBottom - 2});
  for (const ChartLine& c : curves) labels.keep_off(in_px(x, y, c));
  const auto dot_box = [&](const Vec2& p) {
    labels.keep_off({p.x() - 6, p.y() - 6, p.x() + 6, p.y() + 6});
  };
  std::string fewest;
  for (std::size_t i = 0; i < kChartTips.size(); ++i) {
    const auto meet = where_limits_meet(chart, i);
    if (!meet) continue;
    const Vec2 at(x(place_of(meet->teeth)), y(meet->shift));
    // One above the other, where undercut leaves nothing else to draw.
    const double up = 14.0 + 22.0 * static_cast<double>(i);
    svg.line(at, {at.x(), kBottom - up}, "thin dash");
    svg.dot(at, 4.0, "mark");
    dot_box(at);
    const std::string words = fmt::format(" ≥ {}: {}", meet->fewest, kTipNames[i]);
    labels.draw(svg, "z" + words, symbol_svg("z") + words, "halo",
                {{{at.x(), kBottom - up}, {5, 0}, Anchor::start}}, FreeLabels::If::always);
    fewest += fmt::format("{}{} teeth {}", fewest.empty() ? "" : ", ", meet->fewest,
                          i == 0 ? "with a pointed tip" : fmt::format("for {:g}", kChartTips[i]));
  }
  if (design != nullptr) {
    const std::array<int, 2> teeth{design->trial.z1, design->trial.z2};
    for (std::size_t i : {0, 1}) {
      if (!on_chart(teeth[i])) continue;
      const Vec2 at(x(place_of(teeth[i])), y(design->shift[i]));
      svg.dot(at, 6.0, "design-ring");
      svg.dot(at, 2.2, "design-dot");
      dot_box(at);
      const std::string words = fmt::format("gear {}", i + 1);
      labels.draw(svg, words, words, "halo here", places_around(at, 11, {1, 0}),
                  FreeLabels::If::always);
    }
  }
  for (const ChartLine& c : curves) name_on_curve(svg, labels, in_px(x, y, c), c);
  return captioned(
      svg.str(),
      fmt::format(
          "<strong>Limits of the profile shift</strong> of gear 1’s rack{}. {} Below the line "
          "“undercut” the cutter hollows the root; above the tip lines the tooth is thinner "
          "at its tip than 0, 0.2 and 0.4 modules. They meet at the fewest teeth that can be "
          "made at all{}{}.{}",
          helix_words(trial), caption_key("room", "what this search allows"),
          fewest.empty() ? "" : ": ", fewest,
          design != nullptr ? " Ringed: the best design." : ""));
}

std::string identical_gears_figure(const SearchProblem& problem, const Trial& trial) {
  if (problem.crossed() || problem.internal()) return {};
  const auto chart =
      identical_gears_chart(problem, trial.rack, trial.helix[0], kChartMin, kChartMax);
  const std::array<const char*, 5> names{"least shift", "¼", "½", "¾", "greatest"};
  std::vector<ChartLine> curves;
  double lowest = 1.0;
  double highest = 1.8;
  std::optional<int> first;  // to reach 1.2, at the least shift
  for (std::size_t k = 0; k < names.size(); ++k) {
    ChartLine c{{}, names[k], fmt::format("share{}", k)};
    for (const IdenticalGears& row : chart) {
      if (!row.contact_ratio[k]) continue;
      const double eps = *row.contact_ratio[k];
      c.points.push_back({place_of(row.limits.teeth), eps});
      lowest = std::min(lowest, eps);
      highest = std::max(highest, eps);
      if (k == 0 && !first && eps >= kSoundContactRatio) first = row.limits.teeth;
    }
    if (!c.points.empty()) curves.push_back(std::move(c));
  }
  if (curves.empty()) return {};
  const Axis x = teeth_axis(kArea.right + kNames);
  const Axis y = kArea.up(std::max(lowest, 0.8) - 0.05, std::min(highest, 2.6) + 0.05);
  Svg svg("chart-identical", kArea.width, kArea.height(), "Contact ratio of two identical gears",
          "Over the number of teeth, one curve for each of five shifts between the least and the "
          "greatest that the search allows.");
  svg.text({12, 22}, "contact ratio " + symbol_svg("ε_α"), Anchor::start, "panel");
  draw_teeth(svg, x);
  draw_rows(svg, x, y, 8);
  const auto level = [&](double eps, const char* style) {
    if (eps > y.lo && eps < y.hi) svg.line({x.from, y(eps)}, {x.to, y(eps)}, style);
  };
  const double asked = problem.limits.contact_ratio;
  level(kSoundContactRatio, "least-line");
  if (asked != kSoundContactRatio) level(asked, "least-line dash");
  draw_curves(svg, x, y, curves);
  name_curves(svg, x, y, curves);
  if (first) {
    const Vec2 at(x(place_of(*first)), y(kSoundContactRatio));
    svg.line(at, {at.x(), kBottom}, "least-line dash");
    FreeLabels labels({x.from + 2, kTop + 2, x.to - 2, kBottom - 2});
    for (const ChartLine& c : curves) labels.keep_off(in_px(x, y, c));
    const std::string words = fmt::format("z ≥ {}", *first);
    std::vector<LabelPlace> places;
    for (const double up : {14.0, 34.0, 54.0, 80.0}) {
      places.push_back({{at.x(), kBottom - up}, {6, 0}, Anchor::start});
      places.push_back({{at.x(), kBottom - up}, {-6, 0}, Anchor::end});
    }
    labels.draw(svg, words, symbol_svg("z") + fmt::format(" ≥ {}", *first), "halo", places,
                FreeLabels::If::free);
  }
  return captioned(
      svg.str(),
      fmt::format(
          "<strong>Contact ratio of two identical gears</strong>{}, at shifts 0, ¼, ½, ¾ and 1 "
          "of the way from the least to the greatest that this search allows. The straight "
          "line: 1.2, below which spur gears call for unusual care{}. {}The less shift, the "
          "more teeth in mesh; few teeth leave little of either.",
          helix_words(trial),
          asked != kSoundContactRatio ? fmt::format("; dashed: {:g}, asked here", asked) : "",
          first ? fmt::format("From {} teeth on some shift reaches it. ", *first) : ""));
}

}  // namespace gearwright
