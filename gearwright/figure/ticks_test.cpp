#include "gearwright/figure/ticks.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/figure/markup.hpp"

namespace gearwright {
namespace {

TEST(Ticks, TicksAreRoundAndFew) {
  const Ticks angles = round_ticks(11.3, 30.1, 8);
  EXPECT_EQ(angles.decimals, 0);
  ASSERT_EQ(angles.values.size(), 4u);  // 15, 20, 25, 30
  EXPECT_EQ(angles.values.front(), 15.0);
  EXPECT_EQ(angles.values.back(), 30.0);
  const Ticks whole = round_ticks(0.0, 1.0, 10);
  EXPECT_EQ(whole.values.size(), 11u);
  EXPECT_EQ(whole.decimals, 1);
  const Ticks tens = round_ticks(0.0, 60.0, 6);
  EXPECT_EQ(tens.values.size(), 7u);
  EXPECT_EQ(tens.decimals, 0);
  for (const double lo : {-123.4, -1e-7, 0.0, 49.97, 8e5}) {
    for (const double span : {3e-6, 0.9, 1.0, 2.0, 47.0, 5e4}) {
      for (const int most : {3, 4, 7}) {
        const Ticks t = round_ticks(lo, lo + span, most);
        EXPECT_LE(t.values.size(), static_cast<std::size_t>(most) + 1);
        EXPECT_GE(t.values.size(), 1u) << lo << " " << span << " " << most;
        for (const double v : t.values) {
          const double shown = std::round(v * std::pow(10, t.decimals)) / std::pow(10, t.decimals);
          EXPECT_NEAR(v, shown, 1e-9 * span + 1e-12 * std::abs(v));
        }
      }
    }
  }
}

TEST(Ticks, TicksOfPowersKeepTheirDistance) {
  for (const double apart : {0.05, 0.12, 0.25, 0.6}) {
    const Ticks t = log_ticks(7.0, 1000.0, apart);
    EXPECT_EQ(t.values.back(), 1000.0);
    for (std::size_t i = 1; i < t.values.size(); ++i)
      EXPECT_GE(std::log10(t.values[i] / t.values[i - 1]), std::min(apart, std::log10(1.2)));
  }
  EXPECT_EQ(log_ticks(7.0, 100.0, 0.25).values, (std::vector<double>{10, 20, 50, 100}));
}

TEST(Ticks, ASingleValueGetsRoom) {
  for (const double v : {0.0, -3.0, 50.01}) {
    const auto ends = widened(v, v, 0.1);
    EXPECT_LT(ends[0], v);
    EXPECT_GT(ends[1], v);
  }
  const auto ends = widened(1.0, 3.0, 0.1);
  EXPECT_DOUBLE_EQ(ends[0], 0.8);
  EXPECT_DOUBLE_EQ(ends[1], 3.2);
}

TEST(Ticks, TextHasATrueMinusAndGroups) {
  EXPECT_EQ(tick_text(-0.5, 1), "−0.5");
  EXPECT_EQ(tick_text(-0.001, 1), "0.0");
  EXPECT_EQ(tick_text(0.2, -1), "0.2");
  EXPECT_EQ(tick_text(20000, -1), counted(20000));
}

TEST(TrueMinus, OnlySignsOfNumbersOutsideTags) {
  EXPECT_EQ(with_minus("-3.5 to -0.2 mm, x=-1"), "−3.5 to −0.2 mm, x=−1");
  EXPECT_EQ(with_minus("<tspan dy=\"-3\">-3</tspan>"), "<tspan dy=\"-3\">−3</tspan>");
  for (const char* same : {"ISO 6336-5", "gear-1", "double-helical", "1e-05", "A–E", "-"})
    EXPECT_EQ(with_minus(same), same);
}

}  // namespace
}  // namespace gearwright
