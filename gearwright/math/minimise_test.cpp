// Laws: (1) no trial leaves the box, and there are at most `evaluations`; (2) the returned point is
// the best trial; (3) the minima of known functions are found; (4) an exception of f reaches the
// caller; (5) the trials are those of NLopt 2.7.1 (oracle); (6) infinite values and NaN do not stop
// the search.
#include "gearwright/math/minimise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "gearwright/base/progress.hpp"
#include "gearwright/base/testing/draw.hpp"

namespace gearwright {
namespace {

using Point = std::vector<double>;

constexpr Minimiser kBoth[] = {Minimiser::whole_box, Minimiser::downhill};

MinimiserTask task_of(std::size_t n, double lo, double hi, int evaluations) {
  MinimiserTask task{};
  task.lo.assign(n, lo);
  task.hi.assign(n, hi);
  task.step.assign(n, 0.1 * (hi - lo));
  task.evaluations = evaluations;
  return task;
}

// The function of Rosenbrock, whose minimum is 0 at (1, …, 1) in a curved valley.
double rosenbrock(const Point& x) {
  double f = 0.0;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    const double a = x[i + 1] - x[i] * x[i], b = 1.0 - x[i];
    f += 100.0 * a * a + b * b;
  }
  return f;
}

// A function with creases and many local minima. Its least value is at p.
double creased(const Point& x, const Point& p) {
  double f = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double d = std::abs(x[i] - p[i]);
    f = std::max(f, d) + 0.2 * std::abs(d - std::round(4.0 * d) / 4.0);
  }
  return f;
}

TEST(Minimise, TrialsStayInTheBoxAndTheBestIsReturned) {  // (1), (2)
  testing::Draw draw(11);
  for (int k = 0; k < 200; ++k) {
    const auto n = static_cast<std::size_t>(draw.whole(1, 9));
    for (const Minimiser how : kBoth) {
      MinimiserTask task = task_of(n, -draw.uniform(0.1, 2.0), draw.uniform(0.1, 2.0), 0);
      task.evaluations = draw.whole(2, 400);
      Point p(n), start(n);
      for (std::size_t i = 0; i < n; ++i) {
        p[i] = draw.uniform(-2.5, 2.5);  // may lie outside of the box
        start[i] = draw.uniform(0.0, 1.0) < 0.3 ? task.lo[i] : draw.uniform(task.lo[i], task.hi[i]);
      }
      int calls = 0;
      double least = std::numeric_limits<double>::infinity();
      task.f = [&](const Point& x) {
        ++calls;
        for (std::size_t i = 0; i < n; ++i)
          EXPECT_TRUE(task.lo[i] - 1e-15 <= x[i] && x[i] <= task.hi[i] + 1e-15);
        const double f = creased(x, p);
        least = std::min(least, f);
        return f;
      };
      const Point found = minimise(how, task, start);
      EXPECT_LE(calls, task.evaluations);
      EXPECT_EQ(creased(found, p), least);
    }
  }
}

TEST(Minimise, FindsKnownMinima) {  // (3)
  for (const std::size_t n : {1u, 2u, 3u, 5u, 8u}) {
    MinimiserTask task = task_of(n, -3.0, 4.0, 20'000);
    task.f = [](const Point& x) {
      double f = 0.0;
      for (std::size_t i = 0; i < x.size(); ++i)
        f += static_cast<double>(i + 1) * std::pow(x[i] - 0.7, 2);
      return f;
    };
    task.gain = 1e-14;
    for (const double x : minimise(Minimiser::downhill, task, Point(n, -2.0)))
      EXPECT_NEAR(x, 0.7, 1e-5) << n;
  }
  MinimiserTask valley = task_of(2, -2.0, 2.0, 5000);
  valley.f = rosenbrock;
  for (const double x : minimise(Minimiser::downhill, valley, {-1.2, 1.0}))
    EXPECT_NEAR(x, 1.0, 1e-4);
  const Point p{0.31, -1.37};
  MinimiserTask global = task_of(2, -2.0, 2.0, 3000);
  global.f = [&](const Point& x) { return creased(x, p); };
  const Point found = minimise(Minimiser::whole_box, global, {2.0, 2.0});
  EXPECT_NEAR(found[0], p[0], 1e-3);
  EXPECT_NEAR(found[1], p[1], 1e-3);
}

// (6) f may be infinite or NaN in a part of the box, or everywhere.
TEST(Minimise, FindsTheMinimumBesideInfiniteValues) {
  for (const std::size_t n : {1u, 2u, 3u})
    for (const double lost :
         {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
      for (const Minimiser how : kBoth) {
        MinimiserTask task = task_of(n, -1.0, 1.0, 2000);
        const Point p(n, 0.3);
        // The function is finite only in the part x_0 ≥ 0.1 of the box, which contains the minimum
        // and the start.
        task.f = [&](const Point& x) { return x[0] < 0.1 ? lost : creased(x, p); };
        const Point found = minimise(how, task, Point(n, 0.5));
        ASSERT_EQ(found.size(), n);
        EXPECT_LT(creased(found, p), creased(Point(n, 0.5), p));
        task.f = [&](const Point&) { return lost; };
        const Point any = minimise(how, task, Point(n, 0.5));
        ASSERT_EQ(any.size(), n);
        for (const double x : any) EXPECT_LE(std::abs(x), 1.0);
      }
}

// Numbers of trials and the points that NLopt 2.7.1 returns, with 17 digits.
struct KnownMinimum {
  Minimiser how;
  std::size_t n;
  int calls;
  Point found;
};

const KnownMinimum kKnown[] = {
    {Minimiser::whole_box, 1, 700, {0.2999999999999996}},
    {Minimiser::whole_box, 2, 700, {0.94598765432098775, 0.89511888431641529}},
    {Minimiser::whole_box, 3, 700, {0.94854908635201296, 0.89996655320157792, 0.80966019746312412}},
    {Minimiser::whole_box,
     6,
     655,
     {0.16638088705989951, 0.027491998171010668, 0.010916780978509566, 0.0097736625514404096,
      0.0097736625514404096, -0.00051440329218110925}},
    {Minimiser::downhill, 1, 153, {0.3000000000000056}},
    {Minimiser::downhill, 2, 158, {0.95002065886732678, 0.90253942551987132}},
    {Minimiser::downhill, 3, 700, {0.73885188027986604, 0.5505350546446921, 0.30263046294909846}},
    {Minimiser::downhill,
     6,
     700,
     {0.8538781824668209, 0.73465200106452366, 0.54465191988529205, 0.29992402278498431,
      0.084590247102430766, 0.0044081549161510969}},
};

TEST(Minimise, AgreesWithNLopt) {  // (5)
  for (const KnownMinimum& known : kKnown) {
    MinimiserTask task = task_of(known.n, -1.5, 2.25, 700);
    task.relative_gain = 1e-5;
    int calls = 0;
    task.f = [&](const Point& x) {
      ++calls;
      return rosenbrock(x) + 0.1 * std::abs(x[0] - 0.3);
    };
    const Point found = minimise(known.how, task, Point(known.n, -1.1));
    const std::string what =
        std::to_string(known.n) + (known.how == Minimiser::downhill ? " downhill" : " whole box");
    EXPECT_EQ(calls, known.calls) << what;
    EXPECT_EQ(found, known.found) << what;
  }
}

TEST(Minimise, WhatTheFunctionThrowsArrives) {  // (4)
  for (const Minimiser how : kBoth) {
    Progress progress;
    int calls = 0;
    MinimiserTask task = task_of(2, -1.0, 1.0, 200);
    task.f = [&](const Point& x) {
      if (++calls == 5) progress.stop();
      progress.step();
      return x[0] * x[0] + x[1] * x[1];
    };
    EXPECT_THROW(minimise(how, task, {0.5, 0.5}), WorkStopped);
    EXPECT_EQ(calls, 5);
    EXPECT_EQ(progress.state().done, 4);
  }
}

}  // namespace
}  // namespace gearwright
