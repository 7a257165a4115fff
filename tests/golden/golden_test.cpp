// Golden cases are published or recomputed numbers with their source. They are run through the
// interface that users have.
//
// `gearwright verify tests/golden/*.json` runs the same files. Our own output is never golden.
// Every value comes from a publication or from a computation that shares no code with this project.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "gearwright/base/testing/source_file.hpp"
#include "gearwright/job/verify.hpp"

namespace gearwright {
namespace {

std::string text_of(const std::string& name) {
  std::ifstream file(testing::source_file("tests/golden/" + name));
  EXPECT_TRUE(file) << name;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

class Golden : public ::testing::TestWithParam<std::pair<const char*, int>> {};

TEST_P(Golden, CasesHold) {
  const auto [name, count] = GetParam();
  const auto outcomes = verify_cases(text_of(name));
  ASSERT_TRUE(outcomes) << outcomes.error().message();
  EXPECT_EQ(static_cast<int>(outcomes->size()), count);
  for (const CaseOutcome& c : *outcomes) {
    EXPECT_GT(c.values, 0) << c.id;
    for (const std::string& d : c.differences) ADD_FAILURE() << c.id << ": " << d;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Files, Golden,
    ::testing::Values(std::pair{"external.json", 19}, std::pair{"spur_design.json", 18},
                      std::pair{"inspection.json", 66}, std::pair{"conjugate_action.json", 217},
                      std::pair{"small_tooth_numbers.json", 102}, std::pair{"racks.json", 7},
                      std::pair{"drives.json", 75}, std::pair{"double_helical.json", 3},
                      std::pair{"scatter.json", 10}));

TEST(Verify, SeesAWrongNumber) {
  const char* text = R"({"cases": [{"id": "wrong", "source": "none", "verb": "gear",
    "spec": {"gear1": {"teeth": 20, "normal_module_mm": 2, "face_width_mm": 10}},
    "expected": {"gears.0.reference_diameter_mm": 40.001, "gears.0.undercut": true, "gears.0.no_such_key": 1,
                 "gears.7.teeth": 20},
    "tolerance": {"relative": 1e-6}}]})";
  const auto outcomes = verify_cases(text);
  ASSERT_TRUE(outcomes);
  EXPECT_EQ(outcomes->front().differences.size(), 4u);
}

TEST(Verify, ChecksErrorsToo) {
  const char* text = R"({"cases": [{"id": "bad module", "source": "interface", "verb": "gear",
    "spec": {"gear1": {"teeth": 20, "normal_module_mm": -2}},
    "expected": {"error.key": "gear1.normal_module_mm"}}]})";
  const auto outcomes = verify_cases(text);
  ASSERT_TRUE(outcomes);
  EXPECT_TRUE(outcomes->front().differences.empty());
}

TEST(Verify, RefusesFilesThatCheckNothing) {
  EXPECT_FALSE(verify_cases("{}"));
  EXPECT_FALSE(verify_cases(R"({"cases": []})"));
  EXPECT_FALSE(
      verify_cases(R"({"cases": [{"id": "x", "source": "s", "spec": {}, "expected": {}}]})"));
  EXPECT_FALSE(verify_cases("not json"));
}

}  // namespace
}  // namespace gearwright
