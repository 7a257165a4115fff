#include "gearwright/report/report_sections.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "gearwright/base/units.hpp"
#include "gearwright/figure/contact_scene.hpp"
#include "gearwright/figure/gear_shape.hpp"
#include "gearwright/figure/load_figures.hpp"
#include "gearwright/report/testing/page_text.hpp"
#include "gearwright/report/testing/sample_load.hpp"
#include "gearwright/report/testing/strict_html.hpp"

namespace gearwright {
namespace {

using testing::count_of;
using testing::load_sample;
using testing::LoadSample;
using testing::StrictHtml;

const std::array<std::string, 2> kShapes{"gear1", "gear2"};

std::string sound(const LoadSample& s) {
  std::string text = load_section(s.report, kShapes);
  std::string shapes;
  for (std::size_t g = 0; g < 2; ++g) shapes += gear_definition(s.pair->gears[g], kShapes[g]);
  const auto facts =
      StrictHtml::read("<!DOCTYPE html>\n<svg><defs>" + shapes + "</defs></svg>\n" + text);
  for (const std::string& fault : facts.faults) ADD_FAILURE() << fault;
  for (const std::string_view word : {"\"nan", " nan", "inf ", ">nan<"})
    EXPECT_EQ(text.find(word), text.npos) << word;
  return text;
}

TEST(LoadSection, HasAParagraphAndAPictureOfEverything) {
  const LoadSample s = load_sample(testing::spur_pair(), {50e3, 100e3, 200e3}, 0.01);
  const std::string text = sound(s);
  for (const std::string_view id :
       {"loaded-te", "harris", "load-pairs", "load-share", "mesh-stiffness", "pressure1",
        "pressure2", "pressure-along", "root-stress1", "root-stress2", "root-stress-face"})
    EXPECT_NE(text.find("id=\"" + std::string(id)), text.npos) << id;
  EXPECT_EQ(count_of(text, "<h3>"), 4u);
  EXPECT_NE(text.find("quietest at"), text.npos);
  // Each position has one step of the slider and occurs in three pictures. Without the slider, one
  // position is visible.
  EXPECT_EQ(count_of(text, "data-frame=\""), 30u);
  EXPECT_EQ(count_of(text, "data-frames=\"10\">"), 3u);
}

TEST(LoadSection, OneTorqueHasNoHarrisMapAndSaysSo) {
  const std::string text = sound(load_sample(testing::spur_pair(), {100e3}, 0.0));
  EXPECT_EQ(text.find("id=\"harris"), text.npos);
  EXPECT_NE(text.find("If several torques"), text.npos);
}

TEST(LoadSection, OfHelicalGearsAndEitherDriver) {
  for (const bool gear2_drives : {false, true})
    sound(load_sample(testing::helical_pair(), {40e3, 80e3}, 0.02, gear2_drives));
}

// In the picture of an internal gear, the tip is also at the top, and the bars lie in the material.
TEST(LoadSection, OfAnInternalPair) {
  for (const bool gear2_drives : {false, true}) {
    const LoadSample s = load_sample(testing::pinion_in_cut_ring(), {20e3}, 0.0, gear2_drives);
    sound(s);
    const FlankRaster raster = pressure_raster(s.report, 1);
    EXPECT_LT(raster.diameter.front(), raster.diameter.back());
    EXPECT_GT(*std::max_element(raster.gap.begin(), raster.gap.end()),
              0.8 * shown_torque(s.report).max_pressure);
    const auto& points = s.report.contact.root_points[1];
    EXPECT_GT(std::abs(points.front()), std::abs(points.back()));
    EXPECT_GT(points.front().imag(), 0.0);
  }
}

TEST(LoadSection, ManyTorquesShowAFewCurvesAndTheHeaviestField) {
  std::vector<double> torques;
  for (int i = 12; i >= 1; --i) torques.push_back(10e3 * i);
  const LoadSample s = load_sample(testing::spur_pair(), torques, 0.0);
  EXPECT_EQ(shown_torques(s.report).size(), 5u);
  EXPECT_EQ(shown_torques(s.report).front(), 0u);
  EXPECT_EQ(shown_torques(s.report).back(), 11u);
  EXPECT_EQ(shown_torque(s.report).torque, 120e3);
  sound(s);
}

// At each position, the shares of a tooth and its neighbours add up to 1. The shares of one tooth
// over all its positions therefore add up to the number of positions of a pitch.
TEST(LoadSection, SharesAndFieldsAreThoseOfTheContact) {
  const LoadSample s = load_sample(testing::spur_pair(), {150e3}, 0.01);
  const LoadedTorque& t = shown_torque(s.report);
  double sum = 0.0;
  for (const LoadedPosition& p : t.positions)
    for (const LoadedPair& k : p.pairs) sum += k.share;
  EXPECT_NEAR(sum, 10.0, 1e-9);
  for (std::size_t g = 0; g < 2; ++g) {
    const FlankRaster raster = pressure_raster(s.report, g);
    const double most = *std::max_element(raster.gap.begin(), raster.gap.end());
    EXPECT_LE(most, t.max_pressure * (1 + 1e-12));
    EXPECT_GT(most, 0.8 * t.max_pressure);
    EXPECT_DOUBLE_EQ(t.root_stress[g].maxCoeff(), t.max_root_stress[g]);
    const auto& points = s.report.contact.root_points[g];
    ASSERT_EQ(static_cast<Eigen::Index>(points.size()), t.root_stress[g].rows());
    const Gear& gear = s.pair->gears[g];
    EXPECT_LT(std::abs(points.front()), std::abs(points.back()));
    EXPECT_NEAR(std::abs(points.back()), *gear.root_form_radius(), 0.02 * gear.spec.normal_module);
    EXPECT_GT(points.front().imag(), 0.0);
  }
}

double value_at(const std::vector<Vec2>& curve, double x) {
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const double lo = std::min(curve[i - 1].x(), curve[i].x());
    const double hi = std::max(curve[i - 1].x(), curve[i].x());
    if (x < lo || x > hi) continue;
    const double share = (x - curve[i - 1].x()) / (curve[i].x() - curve[i - 1].x());
    return curve[i - 1].y() + share * (curve[i].y() - curve[i - 1].y());
  }
  return 0.0;
}

// At each position, the shares of all tooth pairs add up to 1, and the curve of a pair shows its
// computed share.
TEST(LoadSection, CurvesOfTheToothPairsAddUpToOne) {
  for (const bool gear2_drives : {false, true}) {
    const LoadSample s = load_sample(testing::helical_pair(), {80e3}, 0.01, gear2_drives);
    const auto figure = pair_share_figure(s.report);
    ASSERT_TRUE(figure);
    for (const LoadedPosition& p : shown_torque(s.report).positions) {
      double sum = 0.0;
      for (const FigureMark& m : figure->marks)
        if (m.style.starts_with("curve")) sum += value_at(m.points, p.rotation1.deg());
      EXPECT_NEAR(sum, 1.0, 1e-9) << p.rotation1.deg();
      for (const LoadedPair& k : p.pairs)
        for (const FigureMark& m : figure->marks)
          if (m.words == "tooth pair " + pair_words(k.pair)) {
            EXPECT_NEAR(value_at(m.points, p.rotation1.deg()), share_of(p, k.pair), 1e-9);
          }
    }
  }
}

// If some positions have no result, or if only one has a result, the curves have gaps, but the page
// is still complete.
TEST(LoadSection, PositionsWithoutAnAnswerAreGaps) {
  for (const bool only_one : {false, true}) {
    LoadSample s = load_sample(testing::spur_pair(), {50e3, 150e3}, 0.01);
    for (LoadedTorque& t : s.report.contact.torques) {
      LoadedTorque rest;
      rest.torque = t.torque;
      rest.positions = t.positions;
      for (std::size_t i = 0; i < rest.positions.size(); ++i)
        if (only_one ? i != 4 : i == 4)
          rest.positions[i] =
              LoadedPosition{.rotation1 = rest.positions[i].rotation1, .unfinished = true};
      rest.root_stress = t.root_stress;
      summarise(rest, {28.0, s.pair->gears[0].base_radius(), 0.0, true, LoadRegime::line});
      t = rest;
    }
    const std::string text = sound(s);
    EXPECT_EQ(text.find("id=\"harris"), text.npos);
    EXPECT_NE(text.find("id=\"mesh-stiffness"), text.npos);
  }
}

TEST(LoadSection, StandsInThePage) {
  const LoadSample s = load_sample(testing::spur_pair(), {100e3}, 0.0);
  ReportInput input = testing::report_input(*s.pair);
  EXPECT_EQ(report_html(input).find(">Under load</h2>"), std::string::npos);
  input.load = &s.report;
  const std::string page = report_html(input);
  EXPECT_NE(page.find(">Under load</h2>"), page.npos);
  const auto facts = StrictHtml::read(page);
  for (const std::string& fault : facts.faults) ADD_FAILURE() << fault;
}

}  // namespace
}  // namespace gearwright
