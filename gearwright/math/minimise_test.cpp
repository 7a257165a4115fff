// An exception that the minimised function throws reaches the caller of minimise(), although NLopt
// is a C library.
#include "gearwright/math/minimise.hpp"

#include <gtest/gtest.h>

#include "gearwright/base/progress.hpp"

namespace gearwright {
namespace {

TEST(Minimise, WhatTheFunctionThrowsArrives) {
  ASSERT_TRUE(can_minimise());
  for (const Minimiser how : {Minimiser::whole_box, Minimiser::downhill}) {
    Progress progress;
    int calls = 0;
    MinimiserTask task{};
    task.lo = {-1.0, -1.0};
    task.hi = {1.0, 1.0};
    task.step = {0.1, 0.1};
    task.evaluations = 200;
    task.f = [&](const std::vector<double>& x) {
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
