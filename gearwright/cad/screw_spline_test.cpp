#include "gearwright/cad/screw_spline.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/base/numbers.hpp"
#include "gearwright/cad/testing/outline_distance.hpp"
#include "gearwright/cad/testing/sample_outlines.hpp"

namespace gearwright {
namespace {

Complex as_complex(const Vec2& v) { return {v.x(), v.y()}; }

// Greatest distance from the arc to 1000 points of the spline that the fit did not use.
double measured(const SectionSpline& spline, const Arc& arc) {
  const testing::OutlineDistance distance({1, {arc}});
  double worst = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const Complex c = spline.at((i + 0.618) / 1000.0);
    worst = std::max(worst, distance({c.real(), c.imag()}));
  }
  return worst;
}

TEST(ScrewSpline, EndsAreTheArcsEndsToTheLastBit) {
  for (const Arc& arc : testing::sample_body({.beta = 0.3}).outline.arcs) {
    const SectionSpline spline = fit_section(arc);
    EXPECT_EQ(spline.poles.front(), as_complex(arc.begin_point));
    EXPECT_EQ(spline.poles.back(), as_complex(arc.end_point));
  }
}

TEST(ScrewSpline, SectionIsAsNearAsItSays) {
  for (const int teeth : {12, 20, 150}) {
    for (const Arc& arc :
         testing::sample_body({.teeth = teeth, .beta = 0.5, .chamfer = 0.3}).outline.arcs) {
      const SectionSpline spline = fit_section(arc);
      EXPECT_LE(spline.deviation_mm, kSectionTarget_mm);
      // 1e-11 is the resolution of the oracle's ternary search.
      EXPECT_LE(measured(spline, arc), 1.06 * spline.deviation_mm + 1e-11)
          << teeth << " " << to_string(arc.name);
    }
  }
}

TEST(ScrewSpline, PoleCountsStayWhatTheyAre) {
  const auto body = testing::sample_body({});
  EXPECT_EQ(fit_section(*body.outline.find(ArcName::root_fillet)).basis.poles(), 10);
  EXPECT_EQ(fit_section(*body.outline.find(ArcName::flank)).basis.poles(), 6);
  EXPECT_TRUE(fit_section(*body.outline.find(ArcName::root_fillet)).by_length);
}

TEST(ScrewSpline, InvoluteFromNearItsBaseCircleKeepsTheRollAngle) {
  // If the involute starts at ξ = 0.05, the speed at the start is a tenth of the mean. As a
  // function of arc length, the radius of curvature starts like √s.
  Outline outline{20, {}};
  testing::append(outline, ArcName::flank, std::make_shared<testing::SampleInvolute>(20.0, 0.3),
                  0.05, 0.9);
  const SectionSpline spline = fit_section(outline.arcs[0]);
  EXPECT_FALSE(spline.by_length);
  EXPECT_LE(spline.deviation_mm, kSectionTarget_mm);
  EXPECT_LE(measured(spline, outline.arcs[0]), 1.06 * spline.deviation_mm + 1e-11);
}

// An arc of a circle is followed by a straight line, so the curvature jumps in the middle of the
// curve.
class Hook final : public testing::ComplexCurve {
 public:
  Jet jet(double t) const override {
    if (t < 0.3) {
      const C w = std::polar(1.0, t - 0.3);
      return {C(9, 2) + w, C(0, 1) * w, -w};
    }
    return {C(10, t + 1.7), C(0, 1), 0.0};
  }
  using C = testing::C;
};

TEST(ScrewSpline, HalvesSpansWhereTheCurvatureJumps) {
  Outline outline{20, {}};
  testing::append(outline, ArcName::flank, std::make_shared<Hook>(), -1.0, 0.75);
  const SectionSpline spline = fit_section(outline.arcs[0]);
  EXPECT_LE(spline.deviation_mm, kSectionTarget_mm);
  EXPECT_LE(spline.basis.poles(), kMaxPoles);
  EXPECT_LE(measured(spline, outline.arcs[0]), kSectionMax_mm);
}

TEST(ScrewSpline, HelixTurnsWithinItsTarget) {
  for (const double delta : {1e-6, 0.13, -0.7, kPi, -kPi}) {
    for (const double radius : {1.0, 60.0, 5000.0}) {
      const HelixSpline helix = fit_helix(delta, radius);
      EXPECT_EQ(helix.basis.degree(), 5);
      double worst = 0.0;
      for (int i = 0; i <= 5000; ++i) {
        const double v = i / 5000.0;
        worst = std::max(worst, std::abs(helix.at(v) - std::polar(1.0, delta * (v - 0.5))));
      }
      EXPECT_LE(radius * worst, 1.06 * kHelixTarget_mm) << delta << " " << radius;
    }
  }
}

TEST(ScrewSpline, WithoutTwistTheHelixIsALine) {
  const HelixSpline helix = fit_helix(0.0, 100.0);
  EXPECT_EQ(helix.basis.degree(), 1);
  EXPECT_EQ(helix.poles, (std::vector<Complex>{1.0, 1.0}));
  EXPECT_EQ(helix.deviation, 0.0);
}

TEST(ScrewSpline, MirroredTurnsAreMirroredPoles) {
  const HelixSpline right = fit_helix(0.8, 50.0);
  const HelixSpline left = fit_helix(-0.8, 50.0);
  ASSERT_EQ(right.poles.size(), left.poles.size());
  for (std::size_t i = 0; i < right.poles.size(); ++i) {
    EXPECT_EQ(right.poles[i], std::conj(left.poles[i]));
  }
}

}  // namespace
}  // namespace gearwright
