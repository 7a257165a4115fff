// Tests the search for intervals with functions whose intervals are known.
//
// (1) The ends of the intervals are the roots of the function, except for rounding.
// (2) A narrow hump between two nodes is found.
// (3) A single point is an interval.
// (4) The number of evaluations is limited. The search for a maximum ends as soon as the maximum
//     cannot reach zero, and a root at a node needs no search.
#include "gearwright/design/intervals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "gearwright/design/testing/search_reference.hpp"

namespace gearwright {
namespace {

using testing::search::Random;

constexpr double kUlp = std::numeric_limits<double>::epsilon();
// TOMS 748 (math/root.hpp) closes the bracket of a root to 2 ulp of its ends.
double rounding(double x) { return 4.0 * kUlp * std::max(std::abs(x), 1e-300); }

TEST(Intervals, EndsAreTheRoots) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const double a = random.uniform(-3.0, 0.0);
    const double b = random.uniform(1.0, 4.0);
    const double l = random.uniform(0.01, 0.4);
    const double r = random.uniform(0.6, 0.99);
    const auto f = [&](double x) { return std::min(x - l, 2.0 * (r - x)); };
    const auto found = where_not_negative(f, a, b);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].lo, l, rounding(l));
    EXPECT_NEAR(found[0].hi, r, rounding(r));
  }
}

TEST(Intervals, WhereNothingEndsTheGivenEndsAreKept) {
  const auto all = where_not_negative([](double) { return 1.0; }, -0.3, 0.7);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].lo, -0.3);
  EXPECT_EQ(all[0].hi, 0.7);
  const auto upper = where_not_negative([](double x) { return x; }, -1.0, 2.0);
  ASSERT_EQ(upper.size(), 1u);
  EXPECT_NEAR(upper[0].lo, 0.0, 1e-300);
  EXPECT_EQ(upper[0].hi, 2.0);
  EXPECT_TRUE(where_not_negative([](double x) { return -1.0 - x * x; }, -1.0, 2.0).empty());
  EXPECT_TRUE(where_not_negative([](double) { return 1.0; }, 1.0, 0.0).empty());
}

// Triangular and rounded humps. Their widths range from a third of the distance between nodes down
// to a billionth of it.
TEST(Intervals, NarrowHumpsBetweenNodesAreFound) {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const double half = std::pow(10.0, random.uniform(-10.0, -2.0));
    const double c = random.uniform(0.02, 0.98);
    const bool round = i % 2 == 0;
    const auto f = [&](double x) {
      const double d = std::abs(x - c);
      return round ? (half - d) * (half + d) : half - d;
    };
    const auto found = where_not_negative(f, 0.0, 1.0);
    ASSERT_EQ(found.size(), 1u) << half << " " << c;
    EXPECT_NEAR(found[0].lo, c - half, 4.0 * kUlp) << half;
    EXPECT_NEAR(found[0].hi, c + half, 4.0 * kUlp) << half;
  }
}

// If a hump lies exactly in the middle between two nodes, both nodes have equal values.
TEST(Intervals, AHumpInTheMiddleBetweenNodesIsFoundOnce) {
  for (int node = 0; node < kIntervalNodes; ++node) {
    const double c = (node + 0.5) / kIntervalNodes;
    const auto found =
        where_not_negative([&](double x) { return 1e-6 - std::abs(x - c); }, 0.0, 1.0);
    ASSERT_EQ(found.size(), 1u) << node;
    EXPECT_NEAR(found[0].hi - found[0].lo, 2e-6, 4.0 * kUlp);
  }
}

// A hump next to an end, where the adjacent node has only one neighbour.
TEST(Intervals, HumpsAtTheEndsAreFound) {
  for (const double c : {0.0, 1e-9, 1e-3, 1.0 - 1e-3, 1.0 - 1e-9, 1.0}) {
    const auto found =
        where_not_negative([&](double x) { return 1e-5 - std::abs(x - c); }, 0.0, 1.0);
    ASSERT_EQ(found.size(), 1u) << c;
    EXPECT_NEAR(found[0].lo, std::max(0.0, c - 1e-5), 4.0 * kUlp) << c;
    EXPECT_NEAR(found[0].hi, std::min(1.0, c + 1e-5), 4.0 * kUlp) << c;
  }
}

TEST(Intervals, APointCounts) {
  const auto alone = where_not_negative([](double) { return 0.0; }, 0.5, 0.5);
  ASSERT_EQ(alone.size(), 1u);
  EXPECT_EQ(alone[0].lo, 0.5);
  EXPECT_EQ(alone[0].hi, 0.5);
  EXPECT_TRUE(where_not_negative([](double) { return -1e-300; }, 0.5, 0.5).empty());

  // f rises to 0 at a node or an end and falls again.
  for (const double c : {0.0, 0.25, 0.5, 1.0}) {
    const auto found = where_not_negative([&](double x) { return -std::abs(x - c); }, 0.0, 1.0);
    ASSERT_EQ(found.size(), 1u) << c;
    EXPECT_EQ(found[0].lo, c);
    EXPECT_EQ(found[0].hi, c);
  }
}

// If the humps of a function are wider than the distance between nodes, all are found, in order and
// separately.
TEST(Intervals, ManyHumpsComeInOrder) {
  const double pi = std::numbers::pi;
  const auto found =
      where_not_negative([](double x) { return std::sin(x) - 0.5; }, 0.0, 6.0 * pi, 64);
  ASSERT_EQ(found.size(), 3u);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double turn = 2.0 * pi * static_cast<double>(i);
    EXPECT_NEAR(found[i].lo, turn + pi / 6.0, 1e-14);
    EXPECT_NEAR(found[i].hi, turn + 5.0 * pi / 6.0, 1e-14);
    if (i > 0) {
      EXPECT_LT(found[i - 1].hi, found[i].lo);
    }
  }
}

// Each end of an interval lies on the inner side of the adjacent node, so two intervals never
// overlap.
TEST(Intervals, PiecesOfRandomWavesAreApartAndTrue) {
  Random random(3);
  for (int i = 0; i < 500; ++i) {
    const double w = random.uniform(1.0, 25.0);
    const double shift = random.uniform(0.0, 6.0);
    const double level = random.uniform(-0.9, 0.9);
    const auto f = [&](double x) { return std::sin(w * x + shift) - level; };
    const auto found = where_not_negative(f, 0.0, 1.0);
    double last = -1.0;
    double inside = 0.0;
    for (const Interval& piece : found) {
      EXPECT_GT(piece.lo, last);
      EXPECT_GE(f((piece.lo + piece.hi) / 2.0), 0.0);
      last = piece.hi;
      inside += piece.hi - piece.lo;
    }
    int hits = 0;
    constexpr int kGrid = 2000;
    for (int k = 0; k < kGrid; ++k)
      if (f((k + 0.5) / kGrid) >= 0.0) ++hits;
    // Each end has an error of at most half a cell. In 25 radians there are at most 5 intervals.
    EXPECT_NEAR(inside, static_cast<double>(hits) / kGrid, 5.0 / kGrid) << w << " " << shift;
  }
}

// At a corner of the shift limits, the width is exactly 0 and increases on one side.
TEST(Intervals, AHumpBesideANodeThatIsZeroIsFound) {
  const auto hump = [](double x) { return x * (0.5 - x); };
  const auto right = where_not_negative(hump, 0.0, 24.0);
  ASSERT_EQ(right.size(), 1u);
  EXPECT_EQ(right[0].lo, 0.0);
  EXPECT_NEAR(right[0].hi, 0.5, 1e-15);
  const auto left = where_not_negative([&](double x) { return hump(24.0 - x); }, 0.0, 24.0);
  ASSERT_EQ(left.size(), 1u);
  EXPECT_NEAR(left[0].lo, 23.5, 1e-14);
  EXPECT_EQ(left[0].hi, 24.0);
  const auto only_touching = where_not_negative([](double x) { return -x; }, 0.0, 24.0);
  ASSERT_EQ(only_touching.size(), 1u);
  EXPECT_EQ(only_touching[0].hi, 0.0);
}

// (4) Work counter: 25 nodes, plus a dozen evaluations for a hump whose maximum is −0.07. A golden
// section down to rounding would need sixty. Humps that reach zero give the same intervals as
// without the known `bend`.
TEST(Intervals, HopelessHumpsAreLeftSoon) {
  const Hump known{.bend = 100.0};
  for (const double top : {-0.07, -1.0, 1e-9, 0.3}) {
    for (const double place : {0.31, 0.5, 0.777}) {
      int looks = 0;
      const auto f = [&](double x) {
        ++looks;
        return top - std::max(3.0 * (x - place), place - x) - (x - place) * (x - place);
      };
      const auto found = where_not_negative(f, 0.0, 1.0, kIntervalNodes, known);
      const int work = looks;
      const auto plain = where_not_negative(f, 0.0, 1.0);
      ASSERT_EQ(found.size(), plain.size());
      EXPECT_EQ(found.size(), top > 0.0 ? 1u : 0u);
      for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i].lo, plain[i].lo);
        EXPECT_EQ(found[i].hi, plain[i].hi);
      }
      if (top < 0.0) {
        EXPECT_LE(work, kIntervalNodes + 14);
      }
      EXPECT_EQ(where_not_negative_or_touching(f, 0.0, 1.0, 1e-11, known).size(), found.size());
    }
  }
}

// (4) If a node is 0 except for rounding, it is itself the end, and no bracket around it is needed.
TEST(Intervals, EndsWithinRoundingOfANodeAreThatNode) {
  int looks = 0;
  const auto f = [&](double x) {
    ++looks;
    return std::min(x - 1e-16, 1.0 - 1e-16 - x);
  };
  const auto found = where_not_negative(f, 0.0, 1.0);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].lo, 0.0);
  EXPECT_EQ(found[0].hi, 1.0);
  EXPECT_EQ(looks, kIntervalNodes + 1);
}

}  // namespace
}  // namespace gearwright
