#include "gearwright/spec/read_gear.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "gearwright/base/output_file.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {
namespace {

namespace fs = std::filesystem;

const std::string kGear =
    "[gear1]\nteeth = 17\nnormal_module_mm = 2.5\nface_width_mm = 25\n[gear1.modifications]\n";

Result<JobSpec> spec_with(const std::string& table, const fs::path& folder = {}) {
  return read_spec(kGear + table, SpecFormat::toml, folder);
}

const BothFlanks& flanks(const Result<JobSpec>& spec) {
  if (!spec) throw std::runtime_error(spec.error().message());
  return spec->gears[0]->modifications;
}

// Returns the rejected key. The message must begin with this key.
std::string refusal(const std::string& table, const std::string& word = "",
                    const fs::path& folder = {}) {
  const auto spec = spec_with(table, folder);
  if (spec) return "";
  const Error& e = spec.error();
  EXPECT_EQ(e.message().rfind(e.field, 0), 0u) << e.message();
  EXPECT_NE(e.message().find(word), std::string::npos) << e.message();
  const std::string prefix = "gear1.modifications.";
  return e.field.rfind(prefix, 0) == 0 ? e.field.substr(prefix.size()) : e.field;
}

TEST(ReadModifications, every_key_in_mm) {
  const auto spec = spec_with(R"(
tip_relief_um = 20
tip_relief_start_mm = 46.5
tip_relief_shape = "parabolic"
root_relief_um = 12
root_relief_start_mm = 41
profile_crowning_um = 3
profile_slope_um = -4
lead_crowning_um = 8
lead_slope_um = 5
end_relief_um = 15
end_relief_length_mm = 2.5
end_relief_shape = "linear"
)");
  for (const FlankModifications& m : flanks(spec)) {
    EXPECT_EQ(m.tip_relief.amount, 0.020);
    EXPECT_EQ(m.tip_relief.reach, 46.5);
    EXPECT_EQ(m.tip_relief.shape, ReliefShape::parabolic);
    EXPECT_EQ(m.root_relief.amount, 0.012);
    EXPECT_EQ(m.root_relief.reach, 41.0);
    EXPECT_EQ(m.root_relief.shape, ReliefShape::linear);
    EXPECT_EQ(m.profile_crowning, 0.003);
    EXPECT_EQ(m.profile_slope, -0.004);
    EXPECT_EQ(m.lead_crowning, 0.008);
    EXPECT_EQ(m.lead_slope, 0.005);
    EXPECT_EQ(m.end_relief.amount, 0.015);
    EXPECT_EQ(m.end_relief.reach, 2.5);
    EXPECT_EQ(m.topography, nullptr);
  }
}

TEST(ReadModifications, one_flank_alone_or_otherwise) {
  const auto spec = spec_with(
      "tip_relief_um = 20\ntip_relief_start_mm = 46.5\nleft_tip_relief_um = 10\n"
      "right_lead_crowning_um = 8\n");
  const auto& [right, left] = flanks(spec);
  EXPECT_EQ(right.tip_relief.amount, 0.020);
  EXPECT_EQ(left.tip_relief.amount, 0.010);
  EXPECT_EQ(left.tip_relief.reach, 46.5);
  EXPECT_EQ(right.lead_crowning, 0.008);
  EXPECT_EQ(left.lead_crowning, 0.0);
  EXPECT_TRUE(spec->given.contains("gear1.modifications.left_tip_relief_um"));
  // The start is given for both flanks and the amount for one flank, so the other flank has no
  // relief.
  const auto one = spec_with("tip_relief_start_mm = 46.5\nleft_tip_relief_um = 10\n");
  EXPECT_FALSE(flanks(one)[0].tip_relief.reach);
  EXPECT_TRUE(flanks(one)[1].tip_relief.reach);
}

TEST(ReadModifications, nothing_where_there_is_nothing) {
  const auto spec = spec_with("");
  EXPECT_EQ(flanks(spec)[0].tip_relief.amount, 0.0);
  const auto bare = read_spec("[gear1]\nteeth = 17\nnormal_module_mm = 2", SpecFormat::toml);
  EXPECT_EQ(flanks(bare)[1].lead_crowning, 0.0);
}

TEST(ReadModifications, refusals_name_the_key) {
  EXPECT_EQ(refusal("end_relief_um = 20"), "end_relief_length_mm");
  EXPECT_EQ(refusal("left_end_relief_um = 20", "left_end_relief_um"), "end_relief_length_mm");
  EXPECT_EQ(refusal("tip_relief_um = -20\ntip_relief_start_mm = 46", "slopes can be negative"),
            "tip_relief_um");
  EXPECT_EQ(refusal("right_end_relief_um = -1\nend_relief_length_mm = 2"), "right_end_relief_um");
  EXPECT_EQ(refusal("tip_relief_start_mm = 46"), "tip_relief_start_mm");
  EXPECT_EQ(refusal("tip_relief_shape = \"linear\""), "tip_relief_shape");
  EXPECT_EQ(refusal("left_tip_relief_um = 9\ntip_relief_start_mm = 46\n"
                    "right_tip_relief_start_mm = 45"),
            "right_tip_relief_start_mm");
  EXPECT_EQ(refusal("tip_relief_um = 9\ntip_relief_start_mm = 46\n"
                    "tip_relief_shape = \"round\"",
                    "parabolic"),
            "tip_relief_shape");
  EXPECT_EQ(refusal("end_relief_um = 9\nend_relief_length_mm = -2", "greater than 0"),
            "end_relief_length_mm");
  EXPECT_EQ(refusal("lead_crowning_um = 1\nleft_lead_crowning_um = 2\nright_lead_crowning_um = 3"),
            "lead_crowning_um");
  EXPECT_EQ(refusal("lead_crowning_um = \"much\"", "number"), "lead_crowning_um");
  EXPECT_EQ(refusal("lead_crowing_um = 8", "lead_crowning_um"), "lead_crowing_um");
  // The message names a misspelt key before the key that is missing because of it.
  EXPECT_EQ(refusal("tip_relief_um = 20\ntip_relief_begin_mm = 46", "tip_relief_start_mm"),
            "tip_relief_begin_mm");
  const auto cutter = read_spec(
      "[gear1]\nteeth = 30\nnormal_module_mm = 2\n[gear1.cut_by]\nteeth = 20\n"
      "[gear1.cut_by.modifications]\nlead_crowning_um = 5",
      SpecFormat::toml);
  ASSERT_FALSE(cutter);
  EXPECT_EQ(cutter.error().field, "gear1.cut_by.modifications");
}

TEST(TopographyCsv, a_grid_in_any_order) {
  const auto t = topography_from_csv(
      "\xef\xbb\xbf# measured on a cold day\r\ndiameter_mm, z_mm ,removed_um\r\n\r\n"
      "46,-12,4\r\n42, 12,-2.5\r\n42,-12,1e0\r\n46.0,12,8");
  ASSERT_TRUE(t) << t.error().message();
  EXPECT_EQ(t->diameters, (std::vector<double>{42, 46}));
  EXPECT_EQ(t->heights, (std::vector<double>{-12, 12}));
  EXPECT_EQ(t->removed, (std::vector<double>{0.001, -0.0025, 0.004, 0.008}));
  EXPECT_TRUE(is_grid(*t));
}

TEST(TopographyCsv, refusals_say_where) {
  const auto says = [](const std::string& csv, const std::string& word) {
    const auto t = topography_from_csv(csv);
    if (t) return false;
    EXPECT_NE(t.error().message().find(word), std::string::npos) << t.error().message();
    return true;
  };
  const std::string good = "42,-1,0\n42,1,0\n46,-1,0\n46,1,0\n";
  EXPECT_TRUE(topography_from_csv(good));
  EXPECT_TRUE(says("", "two diameters"));
  EXPECT_TRUE(says("42,0,0\n43,0,0\n", "two heights"));
  EXPECT_TRUE(says("42,-1,0\n42,1,0\n46,1,0\n", "there is no row for diameter 46 and z -1"));
  EXPECT_TRUE(says("42,-1,0\n42,1,0\n46,-1,0\n", "there is no row for diameter 46 and z 1"));
  EXPECT_TRUE(says("42,1,0\n46,-1,0\n46,1,0\n", "there is no row for diameter 42 and z -1"));
  EXPECT_TRUE(says(good + "46,1.0,3\n", "line 5: diameter 46 and z 1 are already in line 4"));
  EXPECT_TRUE(says("42;-1;0\n", "line 1: \"42;-1;0\""));
  EXPECT_TRUE(says("d,z,c\n" + good, "line 1"));
  EXPECT_TRUE(says(good + "diameter_mm,z_mm,removed_um\n", "line 5"));
  EXPECT_TRUE(says(good + "48,1\n", "line 5"));
  EXPECT_TRUE(says(good + "48,1,2,3\n", "line 5"));
  EXPECT_TRUE(says(good + "48,1,2um\n", "line 5"));
  EXPECT_TRUE(says(good + "48,1,\n", "line 5"));
  EXPECT_TRUE(says(good + "48,nan,2\n", "line 5"));
  EXPECT_TRUE(says(good + "48,1e400,2\n", "line 5"));
  EXPECT_TRUE(says(good + "48,1e300,2\n", "line 5"));
  EXPECT_TRUE(says(good + "-48,1,2\n", "greater than 0"));
  EXPECT_TRUE(says(good + "42.0001,-1,0\n42.0001,1,0\n", "closer together"));
}

class TopographyFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() /
              ("gearwright_topography_" +
               std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::create_directories(folder_ / "measured");
    std::ofstream(folder_ / "measured" / "flank.csv") << "40,-13,0\n40,13,1\n49,-13,2\n49,13,3\n";
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path folder_;
};

TEST_F(TopographyFile, starts_at_the_folder_of_the_spec) {
  const auto both = spec_with("topography = \"measured/flank.csv\"", folder_);
  ASSERT_NE(flanks(both)[0].topography, nullptr);
  EXPECT_EQ(flanks(both)[0].topography, flanks(both)[1].topography);
  EXPECT_EQ(flanks(both)[0].topography->removed[3], 0.003);
  const auto left = spec_with("left_topography = \"measured/flank.csv\"", folder_);
  EXPECT_EQ(flanks(left)[0].topography, nullptr);
  ASSERT_NE(flanks(left)[1].topography, nullptr);
  std::ofstream(folder_ / "pair.toml") << kGear << "topography = 'measured/flank.csv'\n";
  const auto file = read_spec_file(folder_ / "pair.toml");
  EXPECT_NE(flanks(file)[0].topography, nullptr);
  const auto absolute =
      spec_with("topography = '" + (folder_ / "measured" / "flank.csv").string() + "'");
  EXPECT_NE(flanks(absolute)[0].topography, nullptr);
}

TEST_F(TopographyFile, refusals_name_the_key_and_the_place) {
  EXPECT_EQ(refusal("topography = 'flank.csv'", "is not a file", folder_), "topography");
  EXPECT_EQ(refusal("topography = 'measured'", "is not a file", folder_), "topography");
  EXPECT_EQ(refusal("topography = ''", "is not a file", folder_), "topography");
  EXPECT_EQ(refusal("topography = '/dev/zero'", "is not a file", folder_), "topography");
  EXPECT_EQ(refusal("topography = 3", "text in quotes", folder_), "topography");
  std::ofstream(folder_ / "bad.csv") << "40,-13,0\n40,13\n";
  EXPECT_EQ(refusal("right_topography = 'bad.csv'", "line 2", folder_), "right_topography");
  std::ofstream(folder_ / "long.csv") << std::string(kMaxTopography + 1, '\n');
  EXPECT_EQ(refusal("topography = 'long.csv'", "bytes", folder_), "topography");
}

}  // namespace
}  // namespace gearwright
