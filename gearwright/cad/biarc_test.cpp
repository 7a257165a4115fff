#include "gearwright/cad/biarc.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/testing/violation.hpp"
#include "gearwright/cad/testing/arc_distance.hpp"
#include "gearwright/cad/testing/odd_outlines.hpp"
#include "gearwright/cad/testing/sample_outlines.hpp"

namespace gearwright {
namespace {

using testing::C;

class Ellipse final : public testing::ComplexCurve {
 public:
  Jet jet(double t) const override {
    const double s = std::sin(t), c = std::cos(t);
    return {C(7 * c, 3 * s), C(-7 * s, 3 * c), C(-7 * c, -3 * s)};
  }
};

// The curvature changes sign at t = 0.
class Cubic final : public testing::ComplexCurve {
 public:
  Jet jet(double t) const override { return {C(t, t * t * t), C(1, 3 * t * t), C(0, 6 * t)}; }
};

Arc arc_on(std::shared_ptr<const Curve> curve, double begin, double end) {
  Outline outline;
  testing::append(outline, ArcName::flank, std::move(curve), begin, end);
  return outline.arcs.front();
}

struct Circle {
  C centre;
  double radius;
  C from, to;
  double bulge;

  C tangent(C p) const {
    const C t = C(0, bulge > 0 ? 1 : -1) * (p - centre);
    return t / std::abs(t);
  }
  C at(double x) const {  // the point at the fraction x of the sweep angle
    return centre + (from - centre) * std::polar(1.0, 4 * std::atan(bulge) * x);
  }
};

Circle circle_of(const BiarcChain& chain, std::size_t i) {
  const C a(chain.points[i].x(), chain.points[i].y());
  const C b(chain.points[i + 1].x(), chain.points[i + 1].y());
  const double bulge = chain.bulges[i];
  const C centre = 0.5 * (a + b) + C(0, 0.25) * (b - a) * (1 / bulge - bulge);
  return {centre, std::abs(a - centre), a, b, bulge};
}

std::vector<Arc> curves() {
  std::vector<Arc> arcs;
  const ToothedBody spur = testing::sample_body({});
  const ToothedBody odd = testing::undercut_body(8, 2.0, 1.25, 0.8, 0.0, 10.0);
  const ToothedBody ring = testing::ring_body(40, 2.0, 0.0, 10.0, 100.0);
  for (const Outline* outline : {&spur.outline, &odd.outline, &ring.outline}) {
    for (const Arc& arc : outline->arcs) {
      if (arc.name == ArcName::flank || arc.name == ArcName::root_fillet) arcs.push_back(arc);
    }
  }
  arcs.push_back(arc_on(std::make_shared<Ellipse>(), 0.1, 1.5));
  arcs.push_back(arc_on(std::make_shared<Ellipse>(), 3.0, 0.2));
  arcs.push_back(arc_on(std::make_shared<Cubic>(), -1.0, 1.3));
  return arcs;
}

TEST(Biarc, EveryPointOfTheChainIsWithinTheTolerance) {
  for (const Arc& arc : curves()) {
    for (const double tolerance : {1e-2, 1e-3, 1e-5}) {
      const BiarcChain chain = fit_biarcs(arc, tolerance);
      EXPECT_LE(chain.deviation_mm, tolerance);
      EXPECT_GT(chain.deviation_mm, 0.1 * tolerance);
      double worst = 0.0;
      for (std::size_t i = 0; i < chain.bulges.size(); ++i) {
        const Circle circle = circle_of(chain, i);
        for (int k = 0; k <= 20; ++k) {
          const C p = circle.at(k / 20.0);
          worst = std::max(worst, testing::distance_to_arc(arc, {p.real(), p.imag()}));
        }
      }
      EXPECT_LE(worst, 1.01 * tolerance);
    }
  }
}

TEST(Biarc, TangentsAreContinuous) {
  for (const Arc& arc : curves()) {
    const BiarcChain chain = fit_biarcs(arc, 1e-3);
    ASSERT_EQ(chain.points.size(), chain.bulges.size() + 1);
    EXPECT_EQ(chain.points.front(), arc.begin_point);
    EXPECT_EQ(chain.points.back(), arc.end_point);
    const auto along_curve = [&](double u) { return std::polar(1.0, arc.at(u).tangent_angle); };
    const Circle first = circle_of(chain, 0);
    EXPECT_LT(std::abs(first.tangent(first.from) - along_curve(0.0)), 1e-9);
    for (std::size_t i = 1; i < chain.bulges.size(); ++i) {
      const Circle before = circle_of(chain, i - 1);
      const Circle after = circle_of(chain, i);
      EXPECT_LT(std::abs(before.tangent(before.to) - after.tangent(after.from)), 2e-9);
    }
    const Circle last = circle_of(chain, chain.bulges.size() - 1);
    EXPECT_LT(std::abs(last.tangent(last.to) - along_curve(1.0)), 1e-9);
  }
}

TEST(Biarc, ThousandTimesFinerIsTenTimesMore) {  // law 1
  for (const Arc& arc : curves()) {
    const std::size_t coarse = fit_biarcs(arc, 1e-5).bulges.size();
    const std::size_t fine = fit_biarcs(arc, 1e-8).bulges.size();
    EXPECT_LE(fine, 10 * coarse + 2);
    EXPECT_GE(fine, 5 * coarse);
  }
}

TEST(Biarc, ArcsOfATooth) {  // 20 teeth of module 2
  const Outline outline = testing::sample_body({}).outline;
  EXPECT_EQ(fit_biarcs(*outline.find(ArcName::root_fillet), 1e-3).bulges.size(), 6U);
  EXPECT_EQ(fit_biarcs(*outline.find(ArcName::flank), 1e-3).bulges.size(), 6U);
}

TEST(Biarc, CircleIsOneArc) {  // law 2
  const Arc arc = arc_on(std::make_shared<testing::SampleCircle>(4.0), 0.2, 3.9);
  const BiarcChain chain = fit_biarcs(arc, 1e-3);
  ASSERT_EQ(chain.bulges.size(), 1U);
  EXPECT_NEAR(chain.bulges[0], std::tan(3.7 / 4), 1e-14);
  EXPECT_LT(chain.deviation_mm, 1e-14);
  const BiarcChain back =
      fit_biarcs(arc_on(std::make_shared<testing::SampleCircle>(4.0), 3.9, 0.2), 1e-3);
  ASSERT_EQ(back.bulges.size(), 1U);
  EXPECT_NEAR(back.bulges[0], -std::tan(3.7 / 4), 1e-14);
}

TEST(Biarc, LineIsOneLine) {
  const Arc arc = arc_on(std::make_shared<testing::SampleLine>(C(1, 2), C(4, 7)), 0.0, 1.0);
  const BiarcChain chain = fit_biarcs(arc, 1e-3);
  ASSERT_EQ(chain.bulges.size(), 1U);
  EXPECT_EQ(chain.bulges[0], 0.0);
}

TEST(Biarc, AreaApproachesThatOfTheEllipse) {
  // A quarter of an ellipse has the area π·7·3/4. Both ends of the arc lie on the axes, so the
  // areas below the chords and the areas of the bulges add up to this value.
  const Arc arc = arc_on(std::make_shared<Ellipse>(), 0.0, kPi / 2);
  for (const double tolerance : {1e-3, 1e-6}) {
    const BiarcChain chain = fit_biarcs(arc, tolerance);
    double area = 0.0;
    for (std::size_t i = 0; i < chain.bulges.size(); ++i) {
      const Vec2& a = chain.points[i];
      const Vec2& b = chain.points[i + 1];
      area += 0.5 * (a.x() * b.y() - a.y() * b.x()) + testing::bulge_area(a, b, chain.bulges[i]);
    }
    EXPECT_NEAR(area, 21 * kPi / 4, 8.2 * tolerance);  // length of the quarter: 8.14
  }
}

TEST(BiarcDeathTest, Contracts) {
  const Arc arc = arc_on(std::make_shared<Ellipse>(), 0.0, 1.0);
  GW_EXPECT_VIOLATION(fit_biarcs(arc, 0.0));
}

}  // namespace
}  // namespace gearwright
