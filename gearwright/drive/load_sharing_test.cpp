// Laws: (1) a spring is exact at its nodes, its force increases with the approach, and its inverse
// returns the approach; (2) nodes of a line give the line; (3) the slope is the derivative; (4)
// bodies between springs are in equilibrium, and a linear problem has its closed form; (5) a body
// that no spring touches does not move.
#include "gearwright/drive/load_sharing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace gearwright::detail {
namespace {

TEST(LoadSpring, IsExactAtItsNodesAndRises) {
  std::mt19937 random(36);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int round = 0; round < 200; ++round) {
    std::vector<SpringNode> nodes;
    double x = 0.0, f = 0.0;
    for (int i = 0; i < 1 + round % 6; ++i) {
      x += 1e-4 + 1e-3 * unit(random);
      f += 1.0 + 500.0 * unit(random);
      nodes.push_back({x, f, (0.1 + 5 * unit(random)) * f / x});
    }
    const LoadSpring spring(nodes);
    for (const SpringNode& node : nodes) {
      EXPECT_NEAR(spring.at(node.approach).force, node.force, 1e-12 * node.force);
      EXPECT_NEAR(spring.approach(node.force), node.approach, 1e-12 * node.approach);
    }
    EXPECT_EQ(spring.at(0.0).force, 0.0);
    EXPECT_EQ(spring.at(-1.0).slope, 0.0);
    double before = 0.0;
    for (int i = 1; i <= 300; ++i) {
      const double at = 1.3 * x * i / 300, h = 1e-7 * x;
      const auto value = spring.at(at);
      EXPECT_GE(value.force, before);
      before = value.force;
      if (value.slope > 1e-3 * f / x) {
        EXPECT_NEAR(spring.approach(value.force), at, 1e-9 * x);
      }
      const double slope = (spring.at(at + h).force - spring.at(at - h).force) / (2 * h);
      EXPECT_NEAR(value.slope, slope, 2e-5 * f / x) << at / x;
    }
  }
}

TEST(LoadSpring, OfALineIsTheLine) {
  const LoadSpring spring({{0.002, 200, 1e5}, {0.001, 100, 1e5}, {0.005, 500, 1e5}});
  const LoadSpring line = LoadSpring::linear(1e5);
  for (const double x : {1e-5, 0.0004, 0.0011, 0.003, 0.02}) {
    EXPECT_NEAR(spring.at(x).force, 1e5 * x, 1e-10);
    EXPECT_NEAR(spring.at(x).slope, 1e5, 1e-7);
    EXPECT_NEAR(line.at(x).force, 1e5 * x, 1e-10);
  }
}

// Two springs in series, and a third spring that its body does not touch.
TEST(LoadSharing, SpringsInSeriesHaveTheirClosedForm) {
  const LoadSpring soft = LoadSpring::linear(2e4), stiff = LoadSpring::linear(6e4);
  SharingProblem problem;
  problem.load = Eigen::Vector2d(90.0, 0.0);
  problem.springs = {{&soft, Eigen::Vector2d(1.0, -1.0), 0.003, 1.0, 90.0},
                     {&stiff, Eigen::Vector2d(0.0, 1.0), -0.001, 1.0, 90.0},
                     {&stiff, Eigen::Vector2d(1.0, 0.0), -1.0, 1.0, 0.0}};
  const SharingSolution found = share_load(problem);
  ASSERT_TRUE(found.found());
  EXPECT_LE(found.iterations, 6);
  EXPECT_NEAR(found.forces[0], 90.0, 1e-9);
  EXPECT_NEAR(found.forces[1], 90.0, 1e-9);
  EXPECT_EQ(found.forces[2], 0.0);
  EXPECT_NEAR(found.x[1], 90.0 / 6e4 + 0.001, 1e-12);
  EXPECT_NEAR(found.x[0], found.x[1] + 90.0 / 2e4 - 0.003, 1e-12);
}

TEST(LoadSharing, ABodyWithoutContactStays) {
  const LoadSpring spring = LoadSpring::linear(1e4);
  SharingProblem problem;
  problem.load = Eigen::Vector2d(10.0, 0.0);
  problem.springs = {{&spring, Eigen::Vector2d(1.0, 0.0), 0.0, 1.0, 10.0},
                     {&spring, Eigen::Vector2d(0.0, 1.0), -2.0, 1.0, 0.0}};
  const SharingSolution found = share_load(problem, Eigen::Vector2d(0.0, 1.25));
  ASSERT_TRUE(found.found());
  EXPECT_NEAR(found.x[0], 1e-3, 1e-14);
  EXPECT_EQ(found.x[1], 1.25);
}

}  // namespace
}  // namespace gearwright::detail
