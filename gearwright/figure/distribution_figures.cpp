#include "gearwright/figure/distribution_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/figure/free_labels.hpp"
#include "gearwright/figure/markup.hpp"

namespace gearwright {

namespace {

constexpr std::size_t kMostBars = 60;
constexpr std::size_t kMostPoints = 400;  // greatest number of points of a curve

std::string shown(double value) { return fmt::format("{:.4g}", value); }

struct Range {
  double least, greatest;
};

Range range_of(const DistributionScene& scene) {
  GW_EXPECTS(scene.values.size() >= 2);
  const auto [least, greatest] = std::minmax_element(scene.values.begin(), scene.values.end());
  GW_EXPECTS(*least < *greatest);
  return {*least, *greatest};
}

FigureAxis value_axis(const DistributionScene& scene) {
  const auto [least, greatest] = range_of(scene);
  return {scene.words, scene.unit, least, greatest};
}

// Draws the percentiles as vertical lines with labels. At the usual width of 560 px, the labels lie
// above `top`, the greatest y of the data. Labels that would overlap on a narrow screen are in
// different rows. A line for which no row has room gets no label.
void add_percentiles(Figure& f, const DistributionScene& scene, double top) {
  constexpr double kNarrow = 320.0, kRow = 17.0;  // px: least width of a plot, height of a row
  constexpr std::size_t kMostRows = 4;
  struct Label {
    double value;
    std::string words;
    std::size_t row;
  };
  auto sorted = scene.percentiles;
  std::sort(sorted.begin(), sorted.end());
  std::vector<Label> labels;
  std::vector<double> ends;  // end of the last label of each row, on the x axis
  for (const auto& [percent, value] : sorted) {
    f.line({{value, -std::numeric_limits<double>::infinity()},
            {value, std::numeric_limits<double>::infinity()}},
           "leader dash");
    std::string words = format_number(percent) + " %";
    const double half = 0.5 * label_width(words + " ") * (f.x.hi - f.x.lo) / kNarrow;
    const auto free = std::find_if(ends.begin(), ends.end(),
                                   [&, at = value](double end) { return end <= at - half; });
    const auto row = static_cast<std::size_t>(free - ends.begin());
    if (row == kMostRows) continue;
    if (free == ends.end()) ends.push_back(0.0);
    ends[row] = value + half;
    labels.push_back({value, std::move(words), row});
  }
  f.y.hi = (1.12 + 0.09 * static_cast<double>(std::max<std::size_t>(ends.size(), 1) - 1)) * top;
  for (const Label& label : labels)
    f.text({label.value, f.y.hi}, escaped(label.words), Anchor::middle, "halo",
           {0, 12 + kRow * static_cast<double>(label.row)});
}

}  // namespace

Figure histogram_figure(const DistributionScene& scene) {
  const auto [least, greatest] = range_of(scene);
  const auto bars = std::clamp<std::size_t>(
      static_cast<std::size_t>(std::sqrt(static_cast<double>(scene.values.size()))), 2, kMostBars);
  const double step = (greatest - least) / static_cast<double>(bars);
  std::vector<double> count(bars, 0.0);
  for (const double v : scene.values)
    ++count[std::min(bars - 1, static_cast<std::size_t>((v - least) / step))];
  const double all = static_cast<double>(scene.values.size());
  const double most = *std::max_element(count.begin(), count.end()) / all * 100;
  Figure f{.id = scene.id,
           .title = "Distribution: " + scene.words,
           .description =
               "The histogram shows the share of the samples in each of several equal intervals of "
               "the value.",
           .caption = fmt::format(" over {} samples, with their percentiles.", scene.values.size()),
           .x = value_axis(scene),
           .y = {"share of the samples", "%"}};
  for (std::size_t i = 0; i < bars; ++i) {
    const double from = least + static_cast<double>(i) * step;
    const double share = 100 * count[i] / all;
    if (share == 0.0) continue;
    f.bar(
        {from, 0.0}, {from + step, share}, "bar alpha",
        fmt::format("{} to {}{}: {} %", shown(from), shown(from + step), scene.unit, shown(share)));
  }
  add_percentiles(f, scene, most);
  return f;
}

Figure cumulative_figure(const DistributionScene& scene) {
  std::vector<double> sorted = scene.values;
  std::sort(sorted.begin(), sorted.end());
  Figure f{
      .id = scene.id + "-below",
      .title = "Cumulative distribution: " + scene.words,
      .description = "The curve shows the share of the samples below each value, from 0 to 100 %.",
      .caption = ". For each value, the curve shows the share of the samples below this value.",
      .x = value_axis(scene),
      .y = {"share of the samples below", "%"}};
  for (const int share : {0, 20, 40, 60, 80, 100})
    f.y.names.push_back({static_cast<double>(share), std::to_string(share)});
  const std::size_t points = std::min(kMostPoints, sorted.size());
  std::vector<Vec2> curve;
  for (std::size_t k = 0; k < points; ++k) {
    const std::size_t i = k * (sorted.size() - 1) / (points - 1);
    curve.push_back(
        {sorted[i], 100.0 * static_cast<double>(i + 1) / static_cast<double>(sorted.size())});
  }
  f.line(std::move(curve), "curve ink", "share below");
  add_percentiles(f, scene, 100.0);
  return f;
}

Figure index_figure(const IndexScene& scene) {
  GW_EXPECTS(!scene.groups.empty());
  const auto n = static_cast<double>(scene.groups.size());
  Figure f{
      .id = scene.id,
      .title = "Share of the variance: " + scene.words,
      .description =
          "The bars show, for each tolerance, the share of the variance that this tolerance "
          "explains alone, and its total share with interactions.",
      .caption =
          ", by Sobol’s indices. For each tolerance, the left bar shows the share that the "
          "tolerance explains alone, and the right bar shows its total share with interactions.",
      .x = {"tolerance", "", 0.3, n + 0.7, true},
      .y = {"share of the variance", "", 0.0, 1.0}};
  f.keys = {{"alpha", "alone"}, {"beta", "total"}};
  for (std::size_t g = 0; g < scene.groups.size(); ++g) {
    const auto& [name, first, total] = scene.groups[g];
    const double at = static_cast<double>(g) + 1.0;
    f.bar({at - 0.36, 0.0}, {at, std::max(0.0, first)}, "bar alpha",
          fmt::format("{}, alone: {}", name, shown(first)));
    f.bar({at, 0.0}, {at + 0.36, std::max(0.0, total)}, "bar beta",
          fmt::format("{}, total: {}", name, shown(total)));
    f.y.hi = std::max(f.y.hi, 1.06 * total);
  }
  return f;
}

Figure ranking_figure(const RankingScene& scene) {
  GW_EXPECTS(!scene.entries.empty());
  double most = 0.0;
  for (const auto& e : scene.entries)
    most = std::max({most, e.percentile, e.mean, e.upper.value_or(0.0)});
  Figure f{
      .id = scene.id,
      .title = "Designs by rank: " + scene.words,
      .description = fmt::format(
          "The picture shows, for each design, the {} point with its confidence interval, and the "
          "mean.",
          scene.percent),
      .caption =
          fmt::format(": the {} point with its confidence interval, and the mean.", scene.percent),
      .x = {"rank", "", 0.4, static_cast<double>(scene.entries.size()) + 0.6, true},
      .y = {scene.words, scene.unit, 0.0, most > 0.0 ? 1.06 * most : 1.0}};
  f.keys = {{"g1", scene.percent + " point"}, {"g2", "mean"}};
  for (std::size_t i = 0; i < scene.entries.size(); ++i) {
    const auto& e = scene.entries[i];
    const double at = static_cast<double>(i) + 1.0;
    if (e.lower && e.upper) f.line({{at, *e.lower}, {at, *e.upper}}, "curve ink");
    f.dot({at, e.mean}, 2.4, "mark g2",
          fmt::format("{}, mean: {}{}", e.name, shown(e.mean), scene.unit));
    f.dot({at, e.percentile}, 2.4, "mark g1",
          fmt::format("{}, {}: {}{}", e.name, scene.percent, shown(e.percentile), scene.unit));
  }
  return f;
}

}  // namespace gearwright
