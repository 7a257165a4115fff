#include "gearwright/cad/svg_outline.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/cad/testing/arc_distance.hpp"
#include "gearwright/cad/testing/odd_outlines.hpp"
#include "gearwright/cad/testing/sample_outlines.hpp"

namespace gearwright {
namespace {

TEST(Bezier, EveryPointIsWithinTheTolerance) {
  for (const ToothedBody& body : {testing::sample_body({.chamfer = 0.3}),
                                  testing::undercut_body(8, 2.0, 1.25, 0.8, 0.0, 10.0)}) {
    for (const Arc& arc : body.outline.arcs) {
      for (const double tolerance : {1e-3, 1e-4, 1e-6}) {
        const BezierChain chain = fit_beziers(arc, tolerance);
        EXPECT_LE(chain.deviation_mm, tolerance);
        ASSERT_EQ(chain.points.size() % 3, 1U);
        EXPECT_EQ(chain.points.front(), arc.begin_point);
        EXPECT_EQ(chain.points.back(), arc.end_point);
        double worst = 0.0;
        for (std::size_t i = 0; i + 3 < chain.points.size(); i += 3) {
          const Vec2* p = &chain.points[i];
          for (int k = 0; k <= 10; ++k) {
            const double x = k / 10.0, y = 1 - x;
            const Vec2 q =
                y * y * y * p[0] + 3 * x * y * y * p[1] + 3 * x * x * y * p[2] + x * x * x * p[3];
            worst = std::max(worst, testing::distance_to_arc(arc, q));
          }
        }
        EXPECT_LE(worst, 1.05 * tolerance);
      }
    }
  }
}

TEST(Bezier, NeighboursShareTheirTangent) {
  const Outline outline = testing::sample_body({}).outline;
  const BezierChain chain = fit_beziers(*outline.find(ArcName::root_fillet), 1e-6);
  ASSERT_GT(chain.points.size(), 7U);
  for (std::size_t i = 3; i + 3 < chain.points.size(); i += 3) {
    const Vec2 in = (chain.points[i] - chain.points[i - 1]).normalized();
    const Vec2 out = (chain.points[i + 1] - chain.points[i]).normalized();
    EXPECT_LT((in - out).norm(), 1e-12);
  }
}

TEST(Bezier, ErrorFallsWithTheFourthPower) {
  const Outline outline = testing::sample_body({}).outline;
  for (const ArcName name : {ArcName::flank, ArcName::root_fillet}) {
    // If the tolerance is 10⁴ times finer, ten times as many pieces are needed. The last piece may
    // be shorter than the others, so the number of pieces may differ by one.
    const std::size_t coarse = fit_beziers(*outline.find(name), 1e-6).points.size() / 3;
    const std::size_t fine = fit_beziers(*outline.find(name), 1e-10).points.size() / 3;
    EXPECT_LE(fine, 10 * coarse + 1);
    EXPECT_GE(fine, 5 * coarse);
  }
}

TEST(Bezier, PiecesCrowdOnlyWhereTheCurveBends) {
  // The curve is an involute that starts at its cusp, where the curvature has no limit.
  const Outline outline = testing::few_tooth_body(1, 5.0, 0.0, 10.0).outline;
  const BezierChain chain = fit_beziers(*outline.find(ArcName::flank), 1e-4);
  EXPECT_LE(chain.deviation_mm, 1e-4);
  EXPECT_LE(chain.points.size() / 3, 12U);
}

}  // namespace
}  // namespace gearwright
