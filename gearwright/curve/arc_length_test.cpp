#include "gearwright/curve/arc_length.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gearwright {
namespace {

struct Ellipse final : Curve {
  double a;
  double b;
  Ellipse(double a_, double b_) : a(a_), b(b_) {}
  Vec2 point(double t) const override { return {a * std::cos(t), b * std::sin(t)}; }
  CurvePoint at(double t) const override {
    return {point(t), std::atan2(b * std::cos(t), -a * std::sin(t)), 0.0};
  }
};

// W(ξ) = r_b (1 + iξ) e^{-iξ}: the length from the base circle is r_b ξ²/2.
struct InvoluteOfTest final : Curve {
  Vec2 point(double xi) const override {
    return {30 * (std::cos(xi) + xi * std::sin(xi)), 30 * (xi * std::cos(xi) - std::sin(xi))};
  }
  CurvePoint at(double xi) const override { return {point(xi), 0.0, 1 / (30 * xi)}; }
};

// Semicubical parabola (t², t³): cusp at t = 0, length ((4 + 9t²)^{3/2} − 8)/27 from there.
struct Cusp final : Curve {
  Vec2 point(double t) const override { return {t * t, t * t * t}; }
  CurvePoint at(double t) const override { return {point(t), 0.0, 0.0}; }
};

// A straight line whose speed is proportional to 1/√t, for which no polynomial series converges
// quickly.
struct SlowLine final : Curve {
  Vec2 point(double t) const override { return {std::sqrt(t), 0.0}; }
  CurvePoint at(double t) const override { return {point(t), 0.0, 0.0}; }
};

TEST(ArcLength, InvoluteInClosedForm) {
  const InvoluteOfTest involute;
  const ArcLength by_length(involute, 0.1, 0.9);
  EXPECT_NEAR(by_length.length(), 30 * (0.81 - 0.01) / 2, 1e-12);
  for (int i = 0; i <= 40; ++i) {
    const double xi = 0.1 + 0.02 * i;
    EXPECT_NEAR(by_length.length_to(xi), 15 * (xi * xi - 0.01), 2e-12);
    EXPECT_NEAR(by_length.parameter(15 * (xi * xi - 0.01)), xi, 1e-12);
  }
}

TEST(ArcLength, EllipseAgainstTheCompleteIntegral) {
  // 4 a E(e), e² = 1 − 1/4: E = 1.2110560275684595248… (Abramowitz, Stegun, table 17.1, m = 0.75).
  const Ellipse ellipse(2.0, 1.0);
  const ArcLength round(ellipse, 0.0, 2 * std::numbers::pi);
  EXPECT_NEAR(round.length(), 8 * 1.2110560275684595248, 2e-13 * 9.7);
  EXPECT_LT(round.error_estimate(), 1e-11);
}

TEST(ArcLength, EndsAreExactAndOutsideIsTheNearerEnd) {  // law 1
  const Ellipse ellipse(3.0, 1.0);
  const ArcLength arc(ellipse, 0.3, 1.7);
  EXPECT_EQ(arc.parameter(0.0), 0.3);
  EXPECT_EQ(arc.parameter(arc.length()), 1.7);
  EXPECT_EQ(arc.parameter(-1.0), 0.3);
  EXPECT_EQ(arc.parameter(99.0), 1.7);
  EXPECT_EQ(arc.length_to(0.3), 0.0);
  EXPECT_EQ(arc.length_to(1.7), arc.length());
  EXPECT_EQ(arc.length_to(0.0), 0.0);
}

TEST(ArcLength, ThereAndBack) {  // laws 2, 3
  const Ellipse ellipse(5.0, 0.5);
  const ArcLength forth(ellipse, 0.2, 2.9);
  const ArcLength back(ellipse, 2.9, 0.2);
  EXPECT_NEAR(forth.length(), back.length(), 1e-12);
  EXPECT_EQ(back.parameter(0.0), 2.9);
  for (int i = 1; i < 100; ++i) {
    const double s = forth.length() * i / 100;
    EXPECT_NEAR(forth.length_to(forth.parameter(s)), s, 1e-12);
    EXPECT_NEAR(back.parameter(back.length() - s), forth.parameter(s), 1e-11);
  }
}

TEST(ArcLength, EqualLengthsAreEqualSteps) {
  // Pieces of equal arc length have equal chords, up to second order in the rotation of the
  // tangent.
  const Ellipse ellipse(5.0, 2.0);
  const ArcLength arc(ellipse, 0.0, 1.5);
  const int n = 4000;
  Vec2 before = ellipse.point(0.0);
  for (int i = 1; i <= n; ++i) {
    const Vec2 here = ellipse.point(arc.parameter(arc.length() * i / n));
    EXPECT_NEAR((here - before).norm() * n / arc.length(), 1.0, 1e-6);
    before = here;
  }
}

TEST(ArcLength, CuspAtTheEnd) {
  const Cusp cusp;
  const ArcLength arc(cusp, 0.0, 1.0);
  EXPECT_NEAR(arc.length(), (std::pow(13.0, 1.5) - 8) / 27, 1e-13);
  for (double s : {1e-9, 1e-6, 0.1, 1.0}) {
    const double t = arc.parameter(s);
    EXPECT_NEAR((std::pow(4 + 9 * t * t, 1.5) - 8) / 27, s, 2e-13);
  }
}

TEST(ArcLength, SaysWhatItCannotResolve) {
  const SlowLine line;
  const ArcLength arc(line, 0.0, 1.0);
  EXPECT_GT(arc.error_estimate(), 1e-6);
  EXPECT_NEAR(arc.length(), 1.0, 10 * arc.error_estimate());
  EXPECT_LE(arc.panels(), 1024);
}

}  // namespace
}  // namespace gearwright
