#include "gearwright/report/contact_figures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/units.hpp"
#include "gearwright/report/testing/sample_contact.hpp"

namespace gearwright {
namespace {

ContactPoint point(double rotation, double te, int pair, TouchKind kind = TouchKind::interior) {
  ContactPoint p;
  p.rotation1 = Angle::radians(rotation);
  p.te = Angle::radians(te);
  p.pair = pair;
  p.kind = kind;
  return p;
}

// Two straight curves, of which the greater counts: the runs meet where they cross, at 1.75.
TEST(TeRuns, TheHandoverIsWhereTheCurvesCross) {
  const auto a = [](double x) { return 10.0 - 2.0 * x; };
  const auto b = [](double x) { return 3.0 + 2.0 * x; };
  std::vector<ContactPoint> points;
  for (int i = 0; i < 5; ++i) points.push_back(a(i) > b(i) ? point(i, a(i), 0) : point(i, b(i), 1));
  points.push_back(point(-1, a(2.0) - 5.0, 9));  // something lower elsewhere: the crossing is seen
  std::rotate(points.begin(), points.end() - 1, points.end());
  const auto runs = te_runs(points);
  ASSERT_EQ(runs.size(), 3u);
  EXPECT_NEAR(runs[1].rotation.back(), 1.75, 1e-12);
  EXPECT_NEAR(runs[1].te.back(), 6.5, 1e-12);
  EXPECT_EQ(runs[1].rotation.back(), runs[2].rotation.front());
  EXPECT_EQ(runs[1].te.back(), runs[2].te.front());
}

TEST(TeRuns, NothingIsDrawnBeyondWhatWasComputed) {
  // The crossing, 6.5, lies below the least value, 7.
  const std::vector<ContactPoint> points{point(0, 10, 0), point(1, 8, 0), point(2, 7, 1),
                                         point(3, 9, 1)};
  for (const TeRun& run : te_runs(points))
    for (const double te : run.te) EXPECT_GE(te, 7.0);
}

TEST(TeRuns, LostContactEndsARunAndEdgesHaveTheirOwn) {
  const std::vector<ContactPoint> points{point(0, 1, 0), point(1, 2, 0, TouchKind::tip1),
                                         point(2, 3, 0, TouchKind::face2),
                                         point(3, 0, 0, TouchKind::none), point(4, 3, 0)};
  const auto runs = te_runs(points);
  ASSERT_EQ(runs.size(), 3u);
  EXPECT_FALSE(runs[0].edge);
  EXPECT_TRUE(runs[1].edge);
  EXPECT_EQ(runs[1].rotation, (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(runs[2].rotation, (std::vector<double>{4}));
}

TEST(TePicture, SaysThePeakToPeakOfTheResult) {
  const auto s = testing::helical_contact();
  const std::string words = "peak to peak " + shown_arcsec(s.report.driving.peak_to_peak.arcsec());
  EXPECT_NE(te_figure(s.report, false).find(words), std::string::npos);
  EXPECT_NE(te_figure(s.report, false).find("end of face 1"), std::string::npos);
  EXPECT_NE(te_figure(s.report, false).find("\"handover\""), std::string::npos);
}

TEST(TePicture, AConjugatePairHasAFlatCurveAndNoWaves) {
  const auto s = testing::perfect_contact();
  EXPECT_NE(te_figure(s.report, false).find("peak to peak 0″"), std::string::npos);
  EXPECT_NE(te_figure(s.report, false).find("along a line"), std::string::npos);
  EXPECT_TRUE(te_spectrum_figure(s.report).empty());
}

TEST(TePicture, ABarForEveryWave) {
  const auto s = testing::helical_contact();
  const std::string text = te_spectrum_figure(s.report);
  std::size_t bars = 0;
  for (std::size_t at = text.find("bar alpha"); at != text.npos;
       at = text.find("bar alpha", at + 1))
    ++bars;
  EXPECT_EQ(bars, s.report.driving.harmonics.size());
}

TEST(TePicture, Digits) {
  EXPECT_EQ(shown_arcsec(1e-9), "0");
  EXPECT_EQ(shown_arcsec(0.0123456), "0.012346");
  EXPECT_EQ(shown_arcsec(1.23456), "1.235");
  EXPECT_EQ(shown_arcsec(-256.94), "-256.9");
}

}  // namespace
}  // namespace gearwright
