// Laws: (1) without deviations, the share of a place is 1 where the pattern of the pair covers the
// place, and 0 elsewhere   (2) a greater δ does not lower any share   (3) the result does not
// depend on the number of threads. Golden: the closed form of [T14.27].
#include "gearwright/scatter/pattern_density.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gearwright/scatter/scatter.hpp"
#include "gearwright/scatter/testing/drawn_pair.hpp"

namespace gearwright {
namespace {

ScatterTask task_of(std::vector<ScatterTolerance> tolerances, int samples, int replicates,
                    const DensityRequest& request) {
  ScatterTask task;
  task.tolerances = std::move(tolerances);
  task.member.positions = 8;
  task.samples = samples;
  task.replicates = replicates;
  task.density = request;
  return task;
}

PatternDensity density_of(const ContactSetup& setup, const ScatterTask& task) {
  auto found = scatter_of(setup, task);
  EXPECT_TRUE(found) << found.error().message();
  return *found->density;
}

TEST(PatternDensity, WithoutWidthItIsThePattern) {
  const ContactSetup setup = testing::crowned_helical_pair().setup();
  DensityRequest request{.positions = 16, .samples = 2, .size = {9, 17}};
  const auto pattern = contact_pattern(setup.pair({}, false), 16, request.size);
  const PatternDensity d = density_of(setup, task_of({testing::crossing(0.0)}, 4, 3, request));
  EXPECT_EQ(d.samples, 6);
  for (const std::size_t which : {0, 1}) {
    EXPECT_EQ(d.flanks[which].diameter, pattern[which].diameter);
    EXPECT_EQ(d.flanks[which].height, pattern[which].height);
    for (std::size_t i = 0; i < pattern[which].gap.size(); ++i)
      EXPECT_EQ(d.flanks[which].count[i], pattern[which].gap[i] <= request.marking ? 6 : 0);
  }
}

TEST(PatternDensity, MoreCompoundLowersNoShareAndThreadsDoNotMatter) {
  const ContactSetup setup = testing::crowned_helical_pair().setup();
  DensityRequest request{.positions = 8, .samples = 8, .size = {5, 9}};
  ScatterTask task = task_of({testing::crossing(0.03), testing::intersecting(0.03)}, 8, 2, request);
  const PatternDensity thin = density_of(setup, task);
  task.threads = 1;
  const PatternDensity again = density_of(setup, task);
  task.density->marking = 0.012;
  const PatternDensity thick = density_of(setup, task);
  bool more = false;
  for (const std::size_t which : {0, 1}) {
    EXPECT_EQ(thin.flanks[which].count, again.flanks[which].count);
    for (std::size_t i = 0; i < thin.flanks[which].count.size(); ++i) {
      EXPECT_GE(thick.flanks[which].count[i], thin.flanks[which].count[i]);
      more = more || thick.flanks[which].count[i] > thin.flanks[which].count[i];
    }
  }
  EXPECT_TRUE(more);
}

TEST(PatternDensity, CountsTheFirstSamplesOfEachReplicate) {
  const ContactSetup setup = testing::crowned_helical_pair().setup();
  const DensityRequest request{.positions = 8, .samples = 4, .size = {5, 9}};
  const auto found = scatter_of(setup, task_of({testing::crossing(0.03)}, 16, 2, request));
  ASSERT_TRUE(found);
  std::array<std::vector<std::int64_t>, 2> count;
  for (const std::size_t n : {0, 1, 2, 3, 16, 17, 18, 19}) {
    ContactErrors errors;
    errors.crossing = Angle::degrees(found->samples[n].x[0]);
    const auto pattern = contact_pattern(setup.pair(errors, false), 8, request.size);
    for (const std::size_t which : {0, 1}) {
      count[which].resize(pattern[which].gap.size());
      for (std::size_t i = 0; i < count[which].size(); ++i)
        count[which][i] += pattern[which].gap[i] <= request.marking ? 1 : 0;
    }
  }
  for (const std::size_t which : {0, 1})
    for (std::size_t i = 0; i < count[which].size(); ++i)
      EXPECT_EQ(found->density->flanks[which].count[i], count[which][i]) << which << ' ' << i;
}

TEST(PatternDensity, IsTheClosedFormOfLeadCrownedSpurTeeth) {
  testing::DrawnPair drawn = testing::spur_pair(false);
  constexpr double kCrowning = 0.02, kFace = 20.0, kRange = 0.05;  // mm, mm, degrees
  drawn.modifications.lead_crowning = kCrowning;
  const ContactSetup setup = drawn.setup();
  const DensityRequest request{.positions = 16, .samples = 64, .size = {5, 41}};
  const PatternDensity d = density_of(setup, task_of({testing::crossing(kRange)}, 64, 4, request));
  const double cos_wt = (setup.gear(1).base_radius() + setup.gear(2).base_radius()) / 60.4;
  const double far = cos_wt * kFace * kFace / (8 * kCrowning) * kRange * kRadPerDeg;  // κw
  const double half = kFace / 2 * std::sqrt(request.marking / kCrowning);             // h
  ASSERT_LT(far, kFace / 2);  // no edge touches
  const FlankDensity& flank = d.flanks[0];
  const std::size_t columns = flank.height.size();
  const std::size_t row = flank.diameter.size() / 2;
  for (std::size_t k = 0; k < columns; ++k) {
    const double z = flank.height[k];
    const double share =
        std::max(0.0, std::min(far, z + half) - std::max(-far, z - half)) / (2 * far);
    // The tolerance allows for one wrong point among the 64 points of each replicate at each end of
    // the interval, and for the second-order terms of the gap.
    EXPECT_NEAR(flank.share(row * columns + k, d.samples), share, 2.0 / 64) << z;
  }
}

}  // namespace
}  // namespace gearwright
