// The face widths of a band. Laws: (1) the next width is the smallest multiple of the step that is
// greater than the previous width, not less than the required width, and within the band; (2) the
// number of steps to the end of a band is at most the number of its widths.
#include "gearwright/design/face_width.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gearwright {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

struct Band {
  SearchProblem problem;
  Trial trial;
};

Band band(double least, double most, double step = 1.0) {
  Band b;
  b.problem.face_width = {{least, most}};
  b.problem.face_step = step;
  b.trial.module = 2.0;
  b.trial.z1 = 20;
  b.trial.z2 = 40;
  return b;
}

// All multiples of the step, in order.
std::optional<double> plain_next(const Band& b, double before, double width) {
  const auto [least, most] = *b.problem.face_width;
  for (int k = 1; k * b.problem.face_step <= most; ++k) {
    const double multiple = k * b.problem.face_step;
    if (multiple > before && multiple >= width && multiple >= least) return multiple;
  }
  return std::nullopt;
}

TEST(FaceWidth, TheNextOneIsGreater) {  // (1)
  for (const double step : {1.0, 0.5, 2.0}) {
    const Band b = band(10.0, 40.0, step);
    for (double before = 0.0; before <= 40.0; before += 0.25) {
      for (double width = 0.0; width <= 44.0; width += 0.25) {
        const auto next = next_face_width(b.problem, b.trial, before, width);
        EXPECT_EQ(next, plain_next(b, before, width)) << step << " " << before << " " << width;
        EXPECT_GT(next.value_or(kNone), before);
      }
    }
  }
}

// The required width may be far below the previous one. The next width must still be greater than
// the previous one, or the loop would not end.
TEST(FaceWidth, ABandEnds) {  // (2)
  const Band b = band(10.0, 120.0, 0.1);
  for (const double share : {0.2, 0.9, 1.0, 1.01}) {
    double width = 0.0;
    int steps = 0;
    while (const auto next = next_face_width(b.problem, b.trial, width, share * width)) {
      ASSERT_GT(*next, width);
      width = *next;
      ASSERT_LE(++steps, 1101);
    }
    EXPECT_NEAR(width, 120.0, 1.5);
  }
}

TEST(FaceWidth, ABandBelowAStepHasItsLeastWidth) {
  const Band b = band(10.2, 10.7);
  EXPECT_EQ(next_face_width(b.problem, b.trial, 0.0, 0.0), 10.2);
  EXPECT_EQ(next_face_width(b.problem, b.trial, 10.2, 0.0), std::nullopt);
  EXPECT_EQ(next_face_width(b.problem, b.trial, 0.0, 10.5), std::nullopt);
}

}  // namespace
}  // namespace gearwright
