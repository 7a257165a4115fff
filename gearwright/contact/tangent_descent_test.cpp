// The descent is compared with minima that are known in closed form, and the spreads with a direct
// evaluation.
#include "gearwright/contact/tangent_descent.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace gearwright {
namespace {

// The curves TE_i(v) = sin(φ_i) (v0 − 3) + cos(2 φ_i) (v1² − 4), at 16 angles φ_i. Their peak to
// peak is 0 at v = (3, 2).
LinearSpreads curve_at(const std::vector<double>& v) {
  LinearSpreads spreads;
  spreads.begin_group();
  for (int i = 0; i < 16; ++i) {
    const double phi = 2 * std::numbers::pi * i / 16;
    const double s = std::sin(phi), c = std::cos(2 * phi);
    spreads.add(s * (v[0] - 3) + c * (v[1] * v[1] - 4), std::array{s, 2 * c * v[1]});
  }
  return spreads;
}

detail::DescentTask task_of(int& evaluations) {
  detail::DescentTask task{{{-10, 10, 1}, {0, 10, 1}}};
  task.gain = 1e-9;
  task.f = [&evaluations](const std::vector<double>& v) {
    ++evaluations;
    return curve_at(v).at({0, 0});
  };
  task.model_at = [](const std::vector<double>& at) {
    return [at, spreads = curve_at(at)](const std::vector<double>& v) {
      return spreads.at({v[0] - at[0], v[1] - at[1]});
    };
  };
  return task;
}

TEST(TangentDescent, FindsTheMinimumOfASpreadInFewSteps) {
  int evaluations = 0;
  const std::vector<double> found = detail::descend(task_of(evaluations), {-8, 7});
  EXPECT_NEAR(found[0], 3.0, 1e-4);
  EXPECT_NEAR(found[1], 2.0, 1e-4);
  EXPECT_LE(evaluations, 20);
}

// Without contact at most points, the descent stays at its start.
TEST(TangentDescent, IsNotWorseThanItsStart) {
  int evaluations = 0;
  detail::DescentTask task = task_of(evaluations);
  task.f = [](const std::vector<double>&) { return 1e9; };
  EXPECT_EQ(detail::descend(task, {5, 1}), (std::vector<double>{5, 1}));
}

TEST(LinearSpreads, AreTheGreatestOfTheirGroups) {
  LinearSpreads one;
  EXPECT_EQ(one.at({1.0}), 0.0);
  one.begin_group();
  one.add(1.0, std::array{2.0});
  one.add(0.0, std::array{0.0});
  LinearSpreads other;
  other.begin_group();
  other.add(-1.0, std::array{0.5});
  other.add(4.0, std::array{0.0});
  one.append(other);
  EXPECT_EQ(one.at({0.0}), 5.0);   // the second group: 4 − (−1)
  EXPECT_EQ(one.at({4.0}), 9.0);   // the first group: 1 + 2·4
  EXPECT_EQ(one.at({-4.0}), 7.0);  // the first group is 0 − (1 − 8); the second one 4 − (−3)
  one.scale(2.0);
  EXPECT_EQ(one.at({2.0}), 9.0);
}

}  // namespace
}  // namespace gearwright
