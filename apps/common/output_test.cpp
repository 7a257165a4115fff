#include "apps/common/output.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "gearwright/base/output_file.hpp"

namespace gearwright::apps {
namespace {

TEST(Guarded, hands_on_the_status_of_the_work) {
  EXPECT_EQ(guarded([] { return 0; }, true), 0);
  EXPECT_EQ(guarded([] { return 4; }, false), 4);
  EXPECT_THROW(guarded([]() -> int { throw IoError("disk full"); }, false), IoError);
}

#ifndef GEARWRIGHT_STOP_AT_VIOLATIONS
TEST(Guarded, a_violation_is_said_and_has_a_status_of_its_own) {
  const auto work = []() -> int {
    GW_EXPECTS(1 > 2);
    return 0;
  };
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  EXPECT_EQ(guarded(work, true), kViolated);
  const std::string sentence = testing::internal::GetCapturedStderr();
  const Json answer = Json::parse(testing::internal::GetCapturedStdout());
  EXPECT_NE(sentence.find("1 > 2 (apps/common/output_test.cpp:"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("please report it, together with the spec"), std::string::npos);
  EXPECT_EQ("gearwright: " + answer["error"]["message"].get<std::string>() + "\n", sentence);
}
#endif

}  // namespace
}  // namespace gearwright::apps
