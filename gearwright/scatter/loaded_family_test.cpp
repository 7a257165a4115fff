// Each member of a family under torque is compared with loaded_contact().
#include "gearwright/scatter/loaded_family.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "gearwright/load/load_summary.hpp"
#include "gearwright/scatter/testing/drawn_pair.hpp"
#include "gearwright/scatter/testing/small_family.hpp"

namespace gearwright {
namespace {

constexpr int kSamples = 4, kFew = 2, kReplicates = 2;

ScatterTask task_of(const ContactSetup& setup, std::vector<ScatterTolerance> tolerances,
                    std::vector<double> torques, bool gear2_drives) {
  ScatterTask task;
  task.tolerances = std::move(tolerances);
  task.member.positions = 4;
  task.member.gear2_drives = gear2_drives;
  task.samples = kSamples;
  task.replicates = kReplicates;
  task.percentiles = {50};
  task.load = testing::loaded_family(setup, std::move(torques), kFew);
  return task;
}

// The scores of the first samples of each replicate, and the indices of these samples.
struct Members {
  std::vector<std::size_t> sample;
  std::vector<std::vector<LoadedScore>> scores;
};

Members members(const ContactSetup& setup, const ScatterTask& task, const Scatter& scatter) {
  Members all;
  for (int r = 0; r < kReplicates; ++r) {
    for (int i = 0; i < kFew; ++i) {
      all.sample.push_back(static_cast<std::size_t>(r * kSamples + i));
      const Deviation d =
          deviation_at(setup, task.tolerances, scatter.samples[all.sample.back()].x);
      const ContactSetup own = setup.with_modifications(d.modifications).value();
      all.scores.push_back(
          loaded_scores(loaded_contact(own.pair(d.errors, task.member.gear2_drives), own.gear(1),
                                       own.gear(2), task.load->compliance, task.load->request)));
    }
  }
  return all;
}

void expect_members(const ContactSetup& setup, const ScatterTask& task, const Scatter& scatter) {
  const Members all = members(setup, task, scatter);
  const auto count = static_cast<std::int64_t>(all.scores.size());
  ASSERT_EQ(scatter.loaded.size(), task.load->request.torques.size());
  for (std::size_t k = 0; k < scatter.loaded.size(); ++k) {
    const LoadedSpread& loaded = scatter.loaded[k];
    EXPECT_EQ(loaded.torque, task.load->request.torques[k]);
    std::vector<double> te, pressure;
    std::vector<std::size_t> sample;
    std::int64_t edges = 0;
    for (std::size_t i = 0; i < all.scores.size(); ++i) {
      if (all.scores[i].empty()) continue;
      te.push_back(all.scores[i][k].peak_to_peak.rad());
      pressure.push_back(all.scores[i][k].max_pressure);
      sample.push_back(all.sample[i]);
      if (all.scores[i][k].edge_carries) ++edges;
    }
    EXPECT_EQ(loaded.unsolved.count, count - static_cast<std::int64_t>(te.size()));
    EXPECT_EQ(loaded.unsolved.of, count);
    EXPECT_EQ(loaded.edge_carries.count, edges);
    ASSERT_EQ(loaded.peak_to_peak.has_value(), !te.empty());
    if (te.empty()) continue;
    EXPECT_EQ(loaded.peak_to_peak->least, *std::min_element(te.begin(), te.end()));
    EXPECT_EQ(loaded.peak_to_peak->greatest, *std::max_element(te.begin(), te.end()));
    EXPECT_EQ(loaded.max_pressure->greatest, *std::max_element(pressure.begin(), pressure.end()));
    const Percentile& middle = loaded.peak_to_peak->percentiles.front();
    const auto named = std::find(sample.begin(), sample.end(), middle.sample);
    ASSERT_NE(named, sample.end());
    const double away =
        std::abs(te[static_cast<std::size_t>(named - sample.begin())] - middle.estimate.value);
    for (const double value : te) EXPECT_LE(away, std::abs(value - middle.estimate.value));
  }
}

// Half a turn about the centre line exchanges the flanks and leaves crossed axes unchanged. With
// intersecting axes, the result depends on which gear drives, so this error is used here.
TEST(LoadedFamily, MembersAreThoseOfLoadedContact) {
  const ContactSetup setup = testing::crowned_helical_pair().setup();
  const ScatterTask task =
      task_of(setup,
              {testing::intersecting(0.3),
               testing::tolerance("gear1.modifications.lead_crowning_um", 1e-3, -10, 10,
                                  VaryingModification{1, Modification::lead_crowning})},
              {5e3, 100e3}, true);
  const auto scatter = scatter_of(setup, task);
  ASSERT_TRUE(scatter) << scatter.error().message();
  expect_members(setup, task, *scatter);
}

// If the centre distance is too great, no teeth touch.
TEST(LoadedFamily, MembersWithoutASolutionAreCounted) {
  const ContactSetup setup = testing::spur_pair(true).setup();
  const ScatterTask task = task_of(setup,
                                   {testing::tolerance("errors.center_distance_mm", 1.0, 0.0, 6.0,
                                                       VaryingError::center_distance)},
                                   {20e3}, false);
  const auto scatter = scatter_of(setup, task);
  ASSERT_TRUE(scatter) << scatter.error().message();
  expect_members(setup, task, *scatter);
  EXPECT_GT(scatter->loaded[0].unsolved.count, 0);
  EXPECT_LT(scatter->loaded[0].unsolved.count, kFew * kReplicates);
}

}  // namespace
}  // namespace gearwright
