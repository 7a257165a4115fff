// Laws of corrections under load: (1) they never increase the percentile   (2) with tolerances of
// width 0, they are the nominal optimum, which a scan finds   (3) they are the same, bit by bit,
// for any number of threads. Oracle: the percentile from loaded_contact(), computed for each member
// separately.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/units.hpp"
#include "gearwright/load/load_summary.hpp"
#include "gearwright/scatter/robust.hpp"
#include "gearwright/scatter/testing/drawn_pair.hpp"
#include "gearwright/scatter/testing/small_family.hpp"

namespace gearwright {
namespace {

constexpr int kLoadedSamples = 16, kLoadedReplicates = 2;
constexpr double kRobustTorque = 150e3;  // N mm

ScatterTask loaded_housing(double crossing_deg) {
  ScatterTask task;
  task.tolerances = {testing::distance(0.0175), testing::crossing(crossing_deg)};
  task.member.positions = 4;
  task.samples = kLoadedSamples;
  task.replicates = kLoadedReplicates;
  return task;
}

RobustTask crowning_under_load(const ContactSetup& setup, double most) {
  return {{{Modification::lead_crowning, 1}},
          {{0.0, most, 2.0}},
          80.0,
          testing::loaded_family(setup, {kRobustTorque}, kLoadedSamples)};
}

double percentile_under_load(const JudgedFamily& f) {
  return f.percentile().estimate.value * kArcsecPerRad;
}

ContactSetup with_crowning(const ContactSetup& setup, double um) {
  SetupChange change;
  change.flank[0][Modification::lead_crowning] = um * kMmPerUm;
  return setup.changed(change).value();
}

// The loaded peak to peak of one member, rad.
double span_of_member(const ContactSetup& setup, const ScatterTask& task, const LoadedFamily& load,
                      const std::vector<double>& x) {
  const Deviation d = deviation_at(setup, task.tolerances, x);
  return loaded_scores(loaded_contact(setup.pair(d.errors, false), setup.gear(1), setup.gear(2),
                                      load.compliance, load.request))
      .at(0)
      .peak_to_peak.rad();
}

// The quantile of the sorted values, interpolated between the two nearest samples.
double sorted_quantile(std::vector<double> f, double p) {
  std::sort(f.begin(), f.end());
  const double at = p * static_cast<double>(f.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const auto above = std::min(below + 1, f.size() - 1);
  return f[below] + (at - static_cast<double>(below)) * (f[above] - f[below]);
}

TEST(RobustLoad, ThePercentileIsThatOfTheMembers) {
  const ContactSetup setup = testing::plain_helical_pair().setup();
  const ScatterTask task = loaded_housing(0.06);
  const RobustTask robust = crowning_under_load(setup, 20);
  const auto found = robust_corrections(setup, task, robust);
  ASSERT_TRUE(found) << found.error().message();
  EXPECT_GT(found->value[0], 0.0);
  EXPECT_LT(percentile_under_load(found->after), percentile_under_load(found->before));
  const ContactSetup with = with_crowning(setup, found->value[0]);
  ASSERT_EQ(found->after.x.size(), static_cast<std::size_t>(kLoadedSamples * kLoadedReplicates));
  std::vector<double> f;
  for (const std::vector<double>& x : found->after.x)
    f.push_back(span_of_member(with, task, *robust.load, x));
  EXPECT_NEAR(percentile_under_load(found->after), sorted_quantile(f, 0.8) * kArcsecPerRad, 1e-9);
  // The samples of the comparison are the same before and after the corrections.
  EXPECT_EQ(found->before.x, found->after.x);
}

TEST(RobustLoad, WithoutWidthItIsTheNominalOptimum) {
  ContactErrors errors;
  errors.crossing = Angle::degrees(0.04);
  testing::DrawnPair drawn = testing::plain_helical_pair();
  drawn.errors = errors;
  const ContactSetup setup = drawn.setup();
  ScatterTask task = loaded_housing(0.0);
  task.tolerances = {testing::distance(0.0)};
  const RobustTask robust = crowning_under_load(setup, 20);
  const auto found = robust_corrections(setup, task, robust);
  ASSERT_TRUE(found) << found.error().message();
  double least = percentile_under_load(found->before);
  for (double um = 0.0; um <= 20.0; um += 0.25)
    least = std::min(
        least, span_of_member(with_crowning(setup, um), task, *robust.load, {0.0}) * kArcsecPerRad);
  EXPECT_LT(percentile_under_load(found->after), 1.001 * least + 0.001);
  EXPECT_LT(least, 0.95 * percentile_under_load(found->before));
  EXPECT_EQ(found->after.peak_to_peak.least, found->after.peak_to_peak.greatest);
}

TEST(RobustLoad, NothingIsWorseThanNothing) {
  const ContactSetup setup = testing::crowned_helical_pair().setup();
  const ScatterTask task = loaded_housing(0.02);
  RobustTask robust = crowning_under_load(setup, 50);
  robust.corrections.push_back({Modification::profile_slope, 2});
  robust.bounds.push_back({-20.0, 20.0, 1.0});
  robust.load = testing::loaded_family(setup, {20e3, kRobustTorque}, kLoadedSamples);
  const auto found = robust_corrections(setup, task, robust);
  ASSERT_TRUE(found) << found.error().message();
  EXPECT_LE(percentile_under_load(found->after), percentile_under_load(found->before));
  EXPECT_EQ(found->after.loaded.size(), 2u);
  EXPECT_EQ(found->after.lost.count, 0);
}

// A cutter lead has no Influence, so each trial repeats the whole contact computation.
TEST(RobustLoad, SettingsWithoutInfluenceAreTriedExactly) {
  const ContactSetup setup = testing::plain_helical_pair().setup();
  ScatterTask task = loaded_housing(0.02);
  task.samples = 4;
  RobustTask robust{{{CutterSetting::cutter_lead, 1}},
                    {{-0.02, 0.02, 0.005}},
                    80.0,
                    testing::loaded_family(setup, {kRobustTorque}, 4)};
  const auto found = robust_corrections(setup, task, robust);
  ASSERT_TRUE(found) << found.error().message();
  EXPECT_LE(percentile_under_load(found->after), percentile_under_load(found->before));
}

TEST(RobustLoad, ThreadsDoNotMatter) {
  const ContactSetup setup = testing::plain_helical_pair().setup();
  ScatterTask task = loaded_housing(0.06);
  const RobustTask robust = crowning_under_load(setup, 20);
  std::vector<double> values, percentiles;
  for (const int threads : {1, 2, 3}) {
    task.threads = threads;
    const auto found = robust_corrections(setup, task, robust);
    ASSERT_TRUE(found);
    values.push_back(found->value[0]);
    percentiles.push_back(percentile_under_load(found->after));
    EXPECT_EQ(values.back(), values[0]);
    EXPECT_EQ(percentiles.back(), percentiles[0]);
  }
}

}  // namespace
}  // namespace gearwright
