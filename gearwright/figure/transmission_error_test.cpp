#include "gearwright/figure/contact_figures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/units.hpp"
#include "gearwright/figure/figure_svg.hpp"
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

// The two curves are straight, and the greater of their values counts. The runs therefore meet at
// the intersection of the curves, 1.75.
TEST(TeRuns, TheHandoverIsWhereTheCurvesCross) {
  const auto a = [](double x) { return 10.0 - 2.0 * x; };
  const auto b = [](double x) { return 3.0 + 2.0 * x; };
  std::vector<ContactPoint> points;
  for (int i = 0; i < 5; ++i) points.push_back(a(i) > b(i) ? point(i, a(i), 0) : point(i, b(i), 1));
  // te_runs() moves intersections outside the range of the values to its ends. The low value of
  // this point extends the range, so that the intersection at 6.5 lies inside.
  points.push_back(point(-1, a(2.0) - 5.0, 9));
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

std::string te_picture(const testing::ContactSample& s) {
  return html_of(transmission_error_figure(s.report, s.report.driving));
}

TEST(TePicture, SaysThePeakToPeakOfTheResult) {
  const auto s = testing::helical_contact();
  const std::string words = "peak to peak " + shown_arcsec(s.report.driving.peak_to_peak.arcsec());
  EXPECT_NE(te_picture(s).find(words), std::string::npos);
  EXPECT_NE(te_picture(s).find("end of face 1"), std::string::npos);
  EXPECT_NE(te_picture(s).find("\"handover\""), std::string::npos);
}

TEST(TePicture, AConjugatePairHasAFlatCurveAndNoWaves) {
  const auto s = testing::perfect_contact();
  EXPECT_NE(te_picture(s).find("peak to peak 0″"), std::string::npos);
  EXPECT_NE(te_picture(s).find("along a line"), std::string::npos);
  EXPECT_FALSE(spectrum_figure(s.report.driving));
}

// The curve over the computed pitch is the result itself, relative to the middle of its range.
TEST(TePicture, TheCurveIsTheResult) {
  const auto s = testing::helical_contact();
  const auto figure = transmission_error_figure(s.report, s.report.driving);
  ASSERT_TRUE(figure);
  const auto& all = s.report.driving.positions;
  const auto [lo, hi] = std::minmax_element(
      all.begin(), all.end(), [](const auto& a, const auto& b) { return a.te < b.te; });
  const double middle = 0.5 * (lo->te.arcsec() + hi->te.arcsec());
  const auto is_drawn = [&](const ContactPoint& p) {
    const Vec2 want(p.rotation1.deg(), p.te.arcsec() - middle);
    return std::any_of(figure->marks.begin(), figure->marks.end(), [&](const FigureMark& m) {
      return !m.words.empty() && std::any_of(m.points.begin(), m.points.end(), [&](const Vec2& at) {
        return (at - want).norm() < 1e-9;
      });
    });
  };
  for (const ContactPoint& p : all) EXPECT_TRUE(is_drawn(p)) << p.rotation1.deg();
}

TEST(TePicture, ABarForEveryWave) {
  const auto s = testing::helical_contact();
  const auto figure = spectrum_figure(s.report.driving);
  ASSERT_TRUE(figure);
  std::vector<double> bars;
  for (const FigureMark& m : figure->marks)
    if (m.kind == FigureMark::Kind::bar) bars.push_back(m.points[1].y());
  ASSERT_EQ(bars.size(), s.report.driving.harmonics.size());
  for (std::size_t i = 0; i < bars.size(); ++i)
    EXPECT_EQ(bars[i], s.report.driving.harmonics[i].arcsec());
}

TEST(TePicture, Digits) {
  EXPECT_EQ(shown_arcsec(1e-9), "0");
  EXPECT_EQ(shown_arcsec(0.0123456), "0.012346");
  EXPECT_EQ(shown_arcsec(1.23456), "1.235");
  EXPECT_EQ(shown_arcsec(-256.94), "-256.9");
}

}  // namespace
}  // namespace gearwright
