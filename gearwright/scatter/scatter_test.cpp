// Laws: (1) samples, percentiles and indices are equal, bit by bit, for any number of threads; (2)
// tolerances of width 0 give the pair as drawn; (3) no sample is worse than the worst case. Golden:
// closed forms of page 14.
#include "gearwright/scatter/scatter.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/math/sobol.hpp"
#include "gearwright/scatter/testing/drawn_pair.hpp"
#include "gearwright/scatter/testing/small_family.hpp"

namespace gearwright {
namespace {

using testing::task_of;
using Q = ScatterQuantity;

Scatter done(const ContactSetup& setup, const ScatterTask& task) {
  auto found = scatter_of(setup, task);
  EXPECT_TRUE(found) << found.error().message();
  return std::move(found).take();
}

const Spread& spread(const Scatter& s, Q q) { return *s.spread[static_cast<std::size_t>(q)]; }
const auto& indices(const Scatter& s, Q q) { return s.indices[static_cast<std::size_t>(q)]; }

TEST(Scatter, ThreadsDoNotMatterUnderLoad) {
  const ContactSetup setup = testing::plain_helical_pair().setup();
  ScatterTask task = task_of({testing::distance(0.02), testing::crossing(0.02)}, 8, 8, 2);
  task.load = testing::loaded_family(setup, {50e3}, 4);
  std::vector<Scatter> all;
  for (const int threads : {1, 2, 3}) {
    task.threads = threads;
    all.push_back(done(setup, task));
  }
  for (const Scatter& s : all) {
    ASSERT_EQ(s.loaded.size(), 1u);
    EXPECT_EQ(s.loaded[0].unsolved.of, 8);
    ASSERT_TRUE(s.loaded[0].peak_to_peak);
    EXPECT_GT(s.loaded[0].peak_to_peak->standard_deviation.value, 0.0);
    EXPECT_EQ(s.loaded[0].peak_to_peak->mean.value, all[0].loaded[0].peak_to_peak->mean.value);
    EXPECT_EQ(s.loaded[0].max_pressure->greatest, all[0].loaded[0].max_pressure->greatest);
    // The sample next to a percentile is one of the samples under load, which are the first 4 of 8.
    for (const Percentile& p : s.loaded[0].peak_to_peak->percentiles) EXPECT_LT(p.sample % 8, 4u);
  }
  // The samples under load give the same numbers as a family that consists of these samples only.
  task.samples = 4;
  const Scatter few = done(setup, task);
  EXPECT_EQ(few.loaded[0].peak_to_peak->mean.value, all[0].loaded[0].peak_to_peak->mean.value);
  EXPECT_EQ(few.loaded[0].max_pressure->greatest, all[0].loaded[0].max_pressure->greatest);
}

TEST(Scatter, ThreadsDoNotMatter) {
  const ContactSetup setup = testing::plain_helical_pair().setup();
  ScatterTask task = task_of({testing::distance(0.02), testing::crossing(0.02)}, 8, 64, 3);
  task.indices = true;
  task.worst_case = true;
  std::vector<Scatter> all;
  for (const int threads : {1, 2, 3}) {
    task.threads = threads;
    all.push_back(done(setup, task));
  }
  for (const Scatter& s : all) {
    ASSERT_EQ(s.samples.size(), 192u);
    for (std::size_t i = 0; i < s.samples.size(); ++i) {
      EXPECT_EQ(s.samples[i].x, all[0].samples[i].x);
      for (const Q q : {Q::peak_to_peak, Q::mean, Q::edge_share, Q::least_play})
        EXPECT_EQ(s.samples[i].member[q], all[0].samples[i].member[q]);
    }
    EXPECT_EQ(spread(s, Q::mean).percentiles[1].estimate.value,
              spread(all[0], Q::mean).percentiles[1].estimate.value);
    EXPECT_EQ(indices(s, Q::peak_to_peak)->total[1].value,
              indices(all[0], Q::peak_to_peak)->total[1].value);
    EXPECT_EQ(s.worst_peak_to_peak->x, all[0].worst_peak_to_peak->x);
  }
}

TEST(Scatter, NoWidthIsThePairAsDrawn) {
  const ContactSetup setup = testing::crowned_helical_pair().setup();
  ScatterTask task = task_of({testing::distance(0.0), testing::crossing(0.0)}, 16, 4, 2);
  task.indices = true;
  task.worst_case = true;
  const Scatter s = done(setup, task);
  const FamilyMember drawn = member_at(setup, deviation_at(setup, {}, {}), task.member);
  for (const Q q : {Q::peak_to_peak, Q::harmonic1, Q::mean, Q::along_face, Q::least_play}) {
    EXPECT_EQ(spread(s, q).mean.value, drawn[q]);
    EXPECT_EQ(spread(s, q).standard_deviation.value, 0.0);
    for (const Percentile& p : spread(s, q).percentiles) {
      EXPECT_EQ(p.estimate.value, drawn[q]);
      EXPECT_EQ(*p.lower, drawn[q]);
    }
    EXPECT_FALSE(indices(s, q));
  }
  EXPECT_EQ(s.worst_peak_to_peak->value, drawn[Q::peak_to_peak]);
  EXPECT_EQ(s.worst_least_play->value, drawn[Q::least_play]);
}

TEST(Scatter, PlainSpurGearsHaveAClosedDistribution) {
  // The median and the 95 % point of |s| from [T14.14], with A_1 for Δγ = ±0.02° and A_2 for Δδ =
  // ±0.03°.
  const ContactSetup setup = testing::spur_pair(false).setup();
  const double r_b1 = setup.gear(1).base_radius();
  const double r_b2 = setup.gear(2).base_radius();
  const double alpha = std::acos((r_b1 + r_b2) / 60.4);
  const double a1 = 0.02 * kRadPerDeg * std::cos(alpha) * 20 / (2 * r_b2);
  const double a2 = 0.03 * kRadPerDeg * std::sin(alpha) * 20 / (2 * r_b2);
  const auto point = [&](double above) {  // P(|s| > t) = above
    const double far = a1 + a2 - std::sqrt(above * 4 * a1 * a2);
    return far >= std::abs(a1 - a2) ? far : (1 - above) * std::max(a1, a2);
  };
  const double median = point(0.5);
  const double p95 = point(0.05);
  ScatterTask task = task_of({testing::crossing(0.02), testing::intersecting(0.03)}, 8, 256);
  task.percentiles = {50, 95};
  const Scatter s = done(setup, task);
  const double drawn = *member_at(setup, deviation_at(setup, {}, {}), task.member)[Q::mean];
  const Spread& mean = spread(s, Q::mean);
  for (const auto& [i, exact] : {std::pair{0, median}, {1, p95}}) {
    const Percentile& p = mean.percentiles[static_cast<std::size_t>(i)];
    EXPECT_NEAR(p.estimate.value - drawn, exact, 4 * *p.estimate.standard_error + 0.002 * exact);
    EXPECT_LT(*p.lower, p.estimate.value);
    EXPECT_GT(*p.upper, p.estimate.value);
    EXPECT_NEAR(*s.samples[p.sample].member[Q::mean], p.estimate.value, 0.01 * a1);
  }
  EXPECT_EQ(s.edge_contact.count, s.edge_contact.of);
  EXPECT_EQ(s.contact_lost.count, 0);
}

TEST(Scatter, IndicesOfThePlayAreSharesOfItsVariance) {
  const ContactSetup setup = testing::spur_pair(false).setup();
  const double r_b2 = setup.gear(2).base_radius();
  const double sine = std::sin(std::acos((setup.gear(1).base_radius() + r_b2) / 60.4));
  ScatterTask task = task_of(
      {testing::distance(0.0175),
       testing::tolerance("gear1.thickness_allowance_mm", 1.0, -0.02, 0.02, VaryingThickness{1}),
       testing::tolerance("gear2.thickness_allowance_mm", 1.0, -0.03, 0.03, VaryingThickness{2})},
      2, 512, 4);
  task.indices = true;
  const Scatter s = done(setup, task);
  const double cosine = std::cos(20 * kRadPerDeg);
  const std::array<double, 3> part{2 * sine * 0.0175, 0.02 * cosine, 0.03 * cosine};
  const double sum = part[0] * part[0] + part[1] * part[1] + part[2] * part[2];
  ASSERT_TRUE(indices(s, Q::least_play));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(indices(s, Q::least_play)->first[i].value, part[i] * part[i] / sum, 0.01);
    EXPECT_NEAR(indices(s, Q::least_play)->total[i].value, part[i] * part[i] / sum, 0.01);
  }
  // If two tolerances form one group, their shares add up.
  task.groups = {{"housing", {0}}, {"teeth", {1, 2}}};
  const Scatter grouped = done(setup, task);
  EXPECT_NEAR(indices(grouped, Q::least_play)->total[1].value, 1 - part[0] * part[0] / sum, 0.01);
  // Conjugate flanks on parallel axes have no transmission error, so no tolerance influences it.
  EXPECT_FALSE(indices(s, Q::peak_to_peak));
}

TEST(Scatter, TheWorstMayLieInside) {
  auto drawn = testing::plain_helical_pair();
  drawn.errors = {.center_distance = -0.0012, .crossing = Angle::degrees(0.0248)};
  ContactSetup setup = drawn.setup();
  for (const int which : {1, 2}) {
    const double slope = which == 1 ? -0.01077 : -0.00401;
    drawn.errors.helix_twist[which - 1] = slope / (setup.gear(which).reference_diameter / 2 * 20);
  }
  setup = drawn.setup();
  ScatterTask task = task_of({testing::intersecting(0.046)}, 32, 32, 2);
  task.worst_case = true;
  const Scatter s = done(setup, task);
  ASSERT_TRUE(s.worst_peak_to_peak && s.worst_least_play);
  // Another program found 0.6353" and 0.7368" at the ends of the range and 4.3057" (to 0.05") at
  // −0.03328°.
  EXPECT_NEAR(s.worst_peak_to_peak->value * kArcsecPerRad, 4.3057, 0.05);
  EXPECT_NEAR(s.worst_peak_to_peak->x[0], -0.03328, 5e-4);
  EXPECT_FALSE(s.worst_peak_to_peak->corner);
  EXPECT_TRUE(s.worst_least_play->corner);
}

TEST(Scatter, NoSampleIsWorse) {
  const ContactSetup setup = testing::plain_helical_pair().setup();
  ScatterTask task = task_of(
      {testing::distance(0.03), testing::crossing(0.02), testing::intersecting(0.02)}, 16, 64, 2);
  task.worst_case = true;
  const Scatter s = done(setup, task);
  for (const ScatterSample& sample : s.samples) {
    ASSERT_TRUE(sample.member[Q::peak_to_peak] && sample.member[Q::least_play]);
    EXPECT_LE(sample.member[Q::peak_to_peak], s.worst_peak_to_peak->value);
    EXPECT_GE(sample.member[Q::least_play], s.worst_least_play->value);
  }
}

TEST(Scatter, JamsAndLostContactAreCounted) {
  auto drawn = testing::spur_pair(false);
  drawn.gears[0].thickness_allowance = drawn.gears[1].thickness_allowance = -0.008;
  ScatterTask task = task_of({testing::distance(0.05)}, 2, 64, 2);
  const ContactSetup setup = drawn.setup();
  const Scatter s = done(setup, task);
  // [T14.14]: the backlash is 0 where 2 sin α_wt ΔC/r_b2 equals the backlash of the drawing.
  const double r_b2 = setup.gear(2).base_radius();
  const double sine = std::sin(std::acos((setup.gear(1).base_radius() + r_b2) / 60.4));
  const double play = *member_at(setup, deviation_at(setup, {}, {}), task.member)[Q::least_play];
  EXPECT_NEAR(s.jam.value, (0.05 - play * r_b2 / (2 * sine)) / 0.1, 0.02);
  EXPECT_GT(s.jam.interval.lower, 0.1);
  task.tolerances = {testing::tolerance("errors.center_distance_mm", 1.0, 0.0, 5.0,
                                        VaryingError::center_distance)};
  const Scatter lost = done(drawn.setup(), task);
  EXPECT_GT(lost.contact_lost.count, 0);
  EXPECT_LT(lost.contact_lost.count, 128);
  EXPECT_TRUE(std::isfinite(spread(lost, Q::mean).mean.value));
}

TEST(Scatter, RandomSamplesHaveRankIntervals) {
  const ContactSetup setup = testing::spur_pair(false).setup();
  ScatterTask task = task_of({testing::distance(0.02)}, 2, 32, 2);
  task.sampling = Sampling::random;
  const Scatter s = done(setup, task);
  // 64 samples are too few for an upper bound of the 95 % point.
  const auto& p = spread(s, Q::least_play).percentiles;
  EXPECT_FALSE(p[2].upper);
  EXPECT_TRUE(p[2].lower && p[1].lower && p[1].upper);
  EXPECT_FALSE(p[0].lower);
}

TEST(Scatter, RefusesWhatCannotBe) {
  const ContactSetup setup = testing::spur_pair(false).setup();
  const std::vector<ScatterTolerance> many(SobolPoints::kMaxDimensions / 2 + 1,
                                           testing::distance(0.01));
  const auto error = scatter_of(setup, task_of(many, 2, 1, 1)).error();
  EXPECT_EQ(error.field, "scatter");
  const auto nothing =
      scatter_of(setup, task_of({testing::tolerance("errors.center_distance_mm", 1.0, 6.0, 7.0,
                                                    VaryingError::center_distance)},
                                2, 4, 2));
  ASSERT_FALSE(nothing);
  EXPECT_TRUE(without_contact(nothing.error()));
}

TEST(Scatter, Stops) {
  const ContactSetup setup = testing::spur_pair(false).setup();
  ScatterTask task = task_of({testing::distance(0.01)}, 8, 64, 2);
  Progress progress;
  progress.stop();
  task.progress = &progress;
  EXPECT_THROW((void)scatter_of(setup, task), WorkStopped);
}

}  // namespace
}  // namespace gearwright
