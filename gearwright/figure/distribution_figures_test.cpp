#include "gearwright/figure/distribution_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace gearwright {
namespace {

DistributionScene scene(std::vector<std::pair<double, double>> percentiles) {
  DistributionScene s{"te", "transmission error", "″", {}, std::move(percentiles)};
  for (int i = 0; i <= 400; ++i) s.values.push_back(6.7 + 0.6 * std::sqrt(i / 400.0));
  return s;
}

std::vector<FigureMark> labels_of(const Figure& f) {
  std::vector<FigureMark> labels;
  for (const FigureMark& m : f.marks)
    if (m.kind == FigureMark::Kind::text) labels.push_back(m);
  return labels;
}

// The plot is 320 px wide, a letter 8 px, and a row of letters 13 px high.
void expect_apart(const Figure& f) {
  const std::vector<FigureMark> labels = labels_of(f);
  const auto x = [&](const FigureMark& m) { return 320 * m.points[0].x() / (f.x.hi - f.x.lo); };
  const auto half = [](const FigureMark& m) { return 4.0 * static_cast<double>(m.words.size()); };
  for (std::size_t i = 0; i < labels.size(); ++i)
    for (std::size_t j = i + 1; j < labels.size(); ++j) {
      const FigureMark &a = labels[i], &b = labels[j];
      EXPECT_TRUE(std::abs(x(a) - x(b)) > half(a) + half(b) ||
                  std::abs(a.offset.y() - b.offset.y()) > 13)
          << a.words << " and " << b.words;
    }
}

TEST(DistributionFigures, LabelsOfPercentilesAreApart) {
  const DistributionScene close =
      scene({{5, 6.83}, {50, 7.12}, {90, 7.265}, {95, 7.283}, {99, 7.297}, {99.9, 7.299}});
  for (const Figure& f : {histogram_figure(close), cumulative_figure(close)}) {
    EXPECT_EQ(labels_of(f).size(), 6u);
    expect_apart(f);
  }
  // The baselines of all rows lie above the data, 100 %, if the plot is 560 px wide.
  const Figure close_together = cumulative_figure(close);
  const double room = (1.0 - 100.0 / close_together.y.hi) * close_together.tall * 560;
  for (const FigureMark& label : labels_of(close_together)) EXPECT_LT(label.offset.y(), room);
  // Percentiles that are far apart are in one row.
  const Figure one = cumulative_figure(scene({{5, 6.83}, {50, 7.12}, {95, 7.283}}));
  expect_apart(one);
  EXPECT_DOUBLE_EQ(one.y.hi, 112.0);
}

TEST(DistributionFigures, LabelsWithoutARowAreLeftOut) {
  std::vector<std::pair<double, double>> many;
  for (int i = 1; i < 100; ++i) many.emplace_back(i, 7.0 + 1e-4 * i);
  const Figure f = histogram_figure(scene(many));
  expect_apart(f);
  EXPECT_GE(labels_of(f).size(), 4u);
  EXPECT_LT(labels_of(f).size(), 9u);
}

}  // namespace
}  // namespace gearwright
