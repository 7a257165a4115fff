// Designs ranked by their scatter: each row is the answer of scatter for the spec of the design,
// the rows are in the order of the percentile, and lists of other files are rejected.
#include "gearwright/job/scatter_study.hpp"
#include "gearwright/job/testing/answered.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "gearwright/base/testing/scratch_folder.hpp"
#include "gearwright/job/search_answer.hpp"

namespace gearwright {
namespace {

JobSpec study_spec() {
  const Json tree =
      Json::parse(R"({"search": {"ratio": [1.95, 2.05], "center_distance_mm": [99, 101],
    "modules_mm": [2, 2.5], "pinion_teeth": [26, 34], "helix_angle_deg": [0, 10], "helix_step_deg": 10,
    "face_width_mm": 20},
    "gear1": {"modifications": {"lead_crowning_um": 6}}, "gear2": {"modifications": {"profile_crowning_um": 4}},
    "scatter": {"samples": 4, "replicates": 2, "percentiles": [95, 50], "indices": true, "pattern": true,
      "errors": {"crossing_deg": [-0.02, 0.02]}, "gear1": {"modifications": {"lead_crowning_um": [-3, 3]}}}})");
  auto spec = read_spec_tree(tree);
  EXPECT_TRUE(spec) << spec.error().message();
  return std::move(spec).take();
}

TEST(ScatterStudy, RowsAreTheAnswersOfScatter) {
  const JobSpec spec = study_spec();
  const auto run = run_study(spec, {});
  ASSERT_TRUE(run) << run.error().message();
  ASSERT_GT(run->designs.size(), 5u);
  EXPECT_TRUE(run->refused.empty());
  const Search search(*spec.search);
  SearchOptions options;
  const auto found = run_search(spec, search, options);
  for (const Json& row : run->designs) {
    const auto n = row["design"].get<std::size_t>();
    const Json pair = pair_spec(spec, search, found->answer.designs[n - 1]);
    EXPECT_EQ(pair["gear1"]["modifications"]["lead_crowning_um"], 6);
    EXPECT_EQ(pair["gear2"]["modifications"]["profile_crowning_um"], 4);
    const Json one = testing::answered(pair, "scatter")["scatter"];
    for (const char* key : {"peak_to_peak_arcsec", "least_play_deg", "probability"})
      EXPECT_EQ(row[key].dump(), one[key].dump()) << key << " of design " << n;
    EXPECT_EQ(row["teeth"][0], pair["gear1"]["teeth"]);
  }
}

// The greatest percentile counts, wherever it is in the list.
TEST(ScatterStudy, IsRankedByTheGreatestPercentile) {
  const auto run = run_study(study_spec(), {});
  ASSERT_TRUE(run);
  const auto of = [](const Json& row) {
    return row["peak_to_peak_arcsec"]["percentiles"][0].get<double>();
  };
  EXPECT_TRUE(std::is_sorted(run->designs.begin(), run->designs.end(),
                             [&](const Json& a, const Json& b) { return of(a) < of(b); }));
}

// If a family loses contact in more than (100 − p) % of its samples, its percentile p has no value.
TEST(ScatterStudy, LostContactComesLast) {
  const auto row = [](int design, double arcsec, double lost) {
    return Json{{"design", design},
                {"peak_to_peak_arcsec", {{"percentiles", {arcsec, 0.0}}}},
                {"probability", {{"contact_lost", {{"value", lost}}}}}};
  };
  StudyRun run;
  rank_rows(study_spec(),
            {row(1, 3.0, 0.0), row(2, 1.0, 0.06), row(3, 2.0, 0.04), row(4, 2.0, 0.0),
             row(6, 2.5, 0.05), Json{{"design", 5}, {"reason", "why"}}},
            run);
  std::vector<int> order;
  for (const Json& r : run.designs) order.push_back(r["design"]);
  EXPECT_EQ(order, (std::vector{3, 4, 6, 1, 2}));  // exactly 5 % of the samples may lose contact
  ASSERT_EQ(run.refused.size(), 1u);
}

TEST(ScatterStudy, ASpecThatIsWrongForAllDesignsIsAnError) {
  Json tree = study_spec().tree->tables;
  tree.erase("scatter");
  const auto none = run_study(read_spec_tree(tree).value(), {});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().field, "scatter.errors");
  tree["scatter"] = {{"errors", {{"crossing_deg", {-0.01, 0.01}}}}, {"groups", {{"a", {"b"}}}}};
  const auto group = run_study(read_spec_tree(tree).value(), {});
  ASSERT_FALSE(group);
  EXPECT_EQ(group.error().field, "scatter.groups.a");
  // The error occurs before a folder is created.
  const testing::ScratchFolder scratch;
  StudyOptions options;
  options.out = scratch.path() / "study";
  tree["scatter"] = {{"quality", 12}};
  const auto quality = run_study(read_spec_tree(tree).value(), options);
  ASSERT_FALSE(quality);
  EXPECT_EQ(quality.error().field, "scatter.quality");
  EXPECT_FALSE(std::filesystem::exists(options.out));
}

// A study is not continued if the file of a topography has the same name but other contents.
TEST(ScatterStudy, TheContentsOfATopographyBelongToTheStudy) {
  const testing::ScratchFolder scratch;
  const auto measured = [&](int um) {
    std::ofstream file(scratch.path() / "flank.csv");
    file << "diameter_mm,z_mm,removed_um\n10,-20," << um << "\n10,20,0\n400,-20,0\n400,20,0\n";
  };
  Json tree = study_spec().tree->tables;
  tree["gear1"]["modifications"] = {{"topography", "flank.csv"}};
  tree["scatter"]["gear1"].erase("modifications");
  StudyOptions options;
  options.out = scratch.path() / "study";
  options.top = 1;
  measured(2);
  const auto run = run_study(read_spec_tree(tree, scratch.path()).value(), options);
  ASSERT_TRUE(run) << run.error().message();
  options.resume = true;
  EXPECT_TRUE(run_study(read_spec_tree(tree, scratch.path()).value(), options));
  measured(3);
  const auto other = run_study(read_spec_tree(tree, scratch.path()).value(), options);
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().field, "--out");
}

}  // namespace
}  // namespace gearwright
