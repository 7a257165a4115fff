#include "gearwright/report/contact_report.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "gearwright/figure/contact_figures.hpp"
#include "gearwright/report/testing/sample_contact.hpp"

namespace gearwright {
namespace {

using testing::ContactSample;

std::vector<ContactSample> samples() {
  return {testing::helical_contact(), testing::crossed_contact(),  testing::crossed_contact(true),
          testing::ring_contact(),    testing::ring_contact(true), testing::perfect_contact()};
}

// The heights and diameters that place_on() computes from the mounted axes agree with those
// computed from the surfaces, for either driving gear and any tilt of the axes.
TEST(ContactReport, PlacesOnTheMountedAxesAreThoseOfTheSurfaces) {
  int count = 0;
  for (const ContactSample& s : samples()) {
    for (const ContactPoint& p : s.report.driving.positions) {
      if (p.kind == TouchKind::none) continue;
      for (std::size_t i = 0; i < 2; ++i) {
        const FlankPlace at = place_on(s.report.axes[i], p.point);
        EXPECT_NEAR(at.height, p.height[i], 1e-9);
        EXPECT_NEAR(2 * at.radius, p.diameter[i], 1e-9);
        ++count;
      }
    }
  }
  EXPECT_GT(count, 300);
}

// The contact ellipse encloses the area in which the exact gap is less than the thickness of a thin
// marking compound. On its border, the gap in a raster of gear 1 therefore equals this thickness.
TEST(ContactReport, TheEllipseIsTheContourOfTheGap) {
  ContactSample s = testing::crossed_contact();
  constexpr double kThin = 2e-4;  // mm
  const ContactResult thin = analyse_contact(*s.pair, {8, 1, kThin});
  const ContactPoint& p = thin.positions[4];
  ASSERT_EQ(p.kind, TouchKind::interior);
  const auto ellipse = ellipse_on(s.report, p, 0);
  ASSERT_FALSE(ellipse.empty());
  const FlankRaster raster = gap_map(*s.pair, p.rotation1, p.pair, {801, 801});
  const auto value = [&](const FlankPlace& at) {
    const double c = (at.height - raster.height.front()) /
                     (raster.height.back() - raster.height.front()) * 800.0;
    const double r = (2 * at.radius - raster.diameter.front()) /
                     (raster.diameter.back() - raster.diameter.front()) * 800.0;
    const auto c0 = static_cast<std::size_t>(c);
    const auto r0 = static_cast<std::size_t>(r);
    const double fc = c - std::floor(c);
    const double fr = r - std::floor(r);
    return (1 - fr) * ((1 - fc) * raster.at(r0, c0) + fc * raster.at(r0, c0 + 1)) +
           fr * ((1 - fc) * raster.at(r0 + 1, c0) + fc * raster.at(r0 + 1, c0 + 1));
  };
  // Nodes are 0.025 mm apart. Between them, a bilinear value is too high by k h²/8, which is 2e-6
  // mm for each direction, or 2 % of the thickness. The ellipse extends over about 0.1 mm on
  // surfaces with radii of 10 mm, so terms of third order contribute another 1 %.
  for (const FlankPlace& at : ellipse) EXPECT_NEAR(value(at) / kThin, 1.0, 0.05);
}

TEST(ContactReport, ATouchWithoutAnEndHasNoEllipse) {
  const ContactSample s = testing::perfect_contact();
  for (const ContactPoint& p : s.report.driving.positions) {
    EXPECT_EQ(p.kind, TouchKind::line);
    EXPECT_TRUE(ellipse_on(s.report, p, 0).empty());
  }
}

TEST(ContactReport, WordsAndKinds) {
  EXPECT_EQ(words_of(NamedAmount{"x", 0.03, "°"}), "+0.03°");
  EXPECT_EQ(words_of(NamedAmount{"x", -12.0, "µm"}), "−12 µm");
  EXPECT_FALSE(is_edge(TouchKind::interior) || is_edge(TouchKind::line) ||
               is_edge(TouchKind::ridge) || is_edge(TouchKind::none));
  for (const TouchKind edge : {TouchKind::tip1, TouchKind::tip2, TouchKind::face1, TouchKind::face2,
                               TouchKind::form1, TouchKind::form2, TouchKind::corner})
    EXPECT_TRUE(is_edge(edge)) << words_of(edge);
}

TEST(ContactReport, ThePathOnAToothIsAPitchOfPositions) {
  for (const ContactSample& s : samples()) {
    const double pitch = pitch_of(s.report);
    std::size_t count = 0;
    double last = -1e300;
    for (const PathPiece& piece : path_on_tooth(s.report)) {
      for (const ContactPoint* p : piece.points) {
        EXPECT_EQ(is_edge(p->kind), piece.edge);
        const double own = p->rotation1.rad() - p->pair * pitch;
        EXPECT_GT(own, last);
        last = own;
        ++count;
      }
    }
    const auto& positions = s.report.driving.positions;
    EXPECT_EQ(count, static_cast<std::size_t>(std::count_if(
                         positions.begin(), positions.end(),
                         [](const ContactPoint& p) { return p.kind != TouchKind::none; })));
  }
}

// On flanks of two arcs, contact ends on one arc and continues on the other. Nothing touches
// between the arcs.
TEST(ContactReport, ThePathOnAToothBreaksWhereTheContactJumps) {
  const std::vector<ContactSample> all = samples();
  ContactReport report = all.front().report;
  const std::size_t pieces = path_on_tooth(report).size();
  auto& positions = report.driving.positions;
  for (std::size_t i = 0; i < positions.size() / 3; ++i)
    positions[i].height[0] += report.gears[0]->spec.face_width;
  EXPECT_GT(path_on_tooth(report).size(), pieces);
}

}  // namespace
}  // namespace gearwright
