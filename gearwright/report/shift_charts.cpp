#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gearwright/base/numbers.hpp"
#include "gearwright/design/shift_charts.hpp"
#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/figure/markup.hpp"
#include "gearwright/report/search_figures.hpp"

namespace gearwright {

namespace {

constexpr double kSoundContactRatio = 1.2;  // the usual least contact ratio of spur gears

Figure over_teeth(Figure f) {
  f.x = {.words = "number of teeth", .unit = {}, .lo = kChartMin, .hi = kChartMax, .symbol = "z"};
  f.x.log = true;
  f.tall = 0.66;
  return f;
}

// Returns the area of the shifts within the limits of the problem. Tooth numbers for which no shift
// is within the limits separate the area into pieces.
std::vector<Vec2> room_of(const std::vector<ShiftLimits>& chart) {
  std::vector<std::vector<Vec2>> pieces;
  std::vector<Vec2> below, above;
  const auto end_piece = [&] {
    below.insert(below.end(), above.rbegin(), above.rend());
    if (above.size() > 1) pieces.push_back(below);
    below.clear();
    above.clear();
  };
  for (const ShiftLimits& row : chart) {
    if (row.min > row.max) {
      end_piece();
      continue;
    }
    below.push_back({row.teeth, row.min});
    above.push_back({row.teeth, row.max});
  }
  end_piece();
  return pieces_of(pieces);
}

// Writes the name of the last curve of a figure beside this curve.
void name_curve(Figure& f) {
  FigureMark& curve = f.marks.back();
  curve.label = curve.words;
  curve.label_style = "halo";
  curve.border = true;
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
  double lowest = 0.0;
  double highest = 1.0;
  for (const ShiftLimits& row : chart) {
    if (row.min > row.max) continue;
    lowest = std::min(lowest, row.min);
    highest = std::max(highest, row.max);
  }
  Figure f = over_teeth(
      {.id = "chart-limits",
       .title = "Limits of the profile shift",
       .description =
           "The curves show, for each number of teeth, the profile shift below which gears are "
           "undercut, and the profile shifts at which tips are pointed, 0.2 modules thick and 0.4 "
           "modules thick.",
       .caption = {},
       .x = {},
       .y = {.words = "profile shift",
             .unit = "modules",
             .lo = std::max(lowest, -2.0) - 0.35,
             .hi = std::min(std::max(highest, 1.4), 3.0) + 0.25,
             .symbol = "x"}});
  f.area(room_of(chart), "room");
  f.keys.push_back({"room", "profile shifts that this search allows"});
  const auto limit = [&](const char* name, const char* style, const auto& of) {
    std::vector<Vec2> points;
    for (const ShiftLimits& row : chart)
      points.push_back(std::isfinite(of(row)) ? Vec2(row.teeth, of(row)) : kNewPiece);
    f.line(std::move(points), fmt::format("curve {}", style), name);
    f.keys.push_back({fmt::format("line {}", style), name});
  };
  constexpr std::array kTipNames{"pointed", "tip 0.2", "tip 0.4"};
  // The first style is for the limit of undercut. The others are for the limits of the tip
  // thickness.
  constexpr std::array kLimitStyles{"limit-undercut bold", "limit-tip dot", "limit-tip",
                                    "limit-tip dash"};
  limit("undercut", kLimitStyles[0], [](const ShiftLimits& row) { return row.undercut; });
  name_curve(f);
  for (std::size_t i = 0; i < kChartTips.size(); ++i)
    limit(kTipNames[i], kLimitStyles[i + 1], [i](const ShiftLimits& row) { return row.tip[i]; });
  std::string fewest;
  for (std::size_t i = 0; i < kChartTips.size(); ++i) {
    const auto meet = where_limits_meet(chart, i);
    if (!meet) continue;
    // The labels are stacked at the bottom of the chart, below the undercut limit, where nothing
    // else is drawn.
    const double level = f.y.lo + (0.05 + 0.09 * static_cast<double>(i)) * (f.y.hi - f.y.lo);
    f.line({{meet->teeth, meet->shift}, {meet->teeth, level}}, "thin dash");
    f.dot({meet->teeth, meet->shift}, 4.0, "mark");
    f.text({meet->teeth, level},
           symbol_svg("z") + fmt::format(" ≥ {}: {}", meet->fewest, kTipNames[i]), Anchor::start,
           "halo", {5.0, 4.0});
    fewest += fmt::format("{}{} teeth {}", fewest.empty() ? "" : ", ", meet->fewest,
                          i == 0 ? "for a pointed tip" : fmt::format("for {:g}", kChartTips[i]));
  }
  for (const std::size_t i : {0u, 1u}) {
    if (design == nullptr) break;
    const int teeth = i == 0 ? design->trial.z1 : design->trial.z2;
    if (!on_chart(teeth)) continue;
    const Vec2 at(teeth, design->shift[i]);
    f.dot(at, 6.0, "design-ring");
    f.dot(at, 2.2, "design-dot");
    f.text(at, fmt::format("gear {}", i + 1), Anchor::start, "halo here",
           {9.0, i == 0 ? -8.0 : 18.0});
  }
  f.caption = fmt::format(
      " of the rack of gear 1{}. Below the line “undercut”, the cutter undercuts the root. On the "
      "line “pointed”, the tooth ends in a point. Above the lines “tip 0.2” and “tip 0.4”, the tip "
      "is thinner than 0.2 modules or 0.4 modules. Each of these lines meets the line "
      "“undercut” at the least number of teeth that can be made{}{}.{}",
      helix_words(trial), fewest.empty() ? "" : ": ", fewest,
      design != nullptr ? " The rings mark the best design." : "");
  return figure_html(f);
}

std::string identical_gears_figure(const SearchProblem& problem, const Trial& trial) {
  if (problem.kind() != PairKind::parallel_external) return {};
  const auto chart =
      identical_gears_chart(problem, trial.rack, trial.helix[0], kChartMin, kChartMax);
  Figure f = over_teeth(
      {.id = "chart-identical",
       .title = "Contact ratio of two identical gears",
       .description =
           "Contact ratio over the number of teeth. Each of the five curves is for one profile "
           "shift between the least and the greatest shift that the search allows.",
       .caption = {},
       .x = {},
       .y = {.words = "contact ratio", .unit = {}, .symbol = "ε_α"}});
  constexpr std::array kNames{"least shift", "¼ of the way", "½", "¾", "greatest shift"};
  constexpr std::array kShareStyles{"share0 dot", "share1 dash", "share2", "share3 dashdot",
                                    "share4 bold"};
  double lowest = 1.0;
  double highest = 1.8;
  std::optional<int> first;  // least number of teeth with ε_α ≥ 1.2 at the least shift
  for (std::size_t k = 0; k < kNames.size(); ++k) {
    std::vector<Vec2> points;
    for (const IdenticalGears& row : chart) {
      if (!row.contact_ratio[k]) continue;
      const double eps = *row.contact_ratio[k];
      points.push_back({row.limits.teeth, eps});
      lowest = std::min(lowest, eps);
      highest = std::max(highest, eps);
      if (k == 0 && !first && eps >= kSoundContactRatio) first = row.limits.teeth;
    }
    if (points.empty()) continue;
    f.line(std::move(points), std::string("curve ") + kShareStyles[k], kNames[k]);
    name_curve(f);
    f.keys.push_back({std::string("line ") + kShareStyles[k], kNames[k]});
  }
  if (f.marks.empty()) return {};
  f.y.lo = std::max(lowest, 0.8) - 0.05;
  f.y.hi = std::min(highest, 2.6) + 0.05;
  const double asked = problem.limits.contact_ratio;
  const auto level = [&](double eps, const char* style) {
    f.line({{-kInfinity, eps}, {kInfinity, eps}}, style);
  };
  level(kSoundContactRatio, "least-line");
  if (asked != kSoundContactRatio) level(asked, "least-line dash");
  if (first) {
    f.line({{*first, kSoundContactRatio}, {*first, -kInfinity}}, "least-line dash");
    f.text({*first, -kInfinity}, symbol_svg("z") + fmt::format(" ≥ {}", *first), Anchor::start,
           "halo", {6.0, -10.0});
  }
  f.caption = fmt::format(
      "{}. The curves are for five profile shifts, in equal steps from the least to the greatest "
      "shift that this search allows. The straight line marks a contact ratio of 1.2, below which "
      "spur gears require unusual care{}. {}A smaller profile shift gives a greater contact ratio. "
      "With few teeth, profile shift and contact ratio are limited.",
      helix_words(trial),
      asked != kSoundContactRatio
          ? fmt::format(". The dashed line marks the required contact ratio of {:g}", asked)
          : "",
      first ? fmt::format("From {} teeth on, some profile shift reaches 1.2. ", *first) : "");
  return figure_html(f);
}

}  // namespace gearwright
