#include "gearwright/report/page_parts.hpp"

#include <gtest/gtest.h>

#include "gearwright/report/testing/sample_reports.hpp"

namespace gearwright {
namespace {

TEST(Turning, StandsStillUntilAsked) {
  const std::string control = turn_control(testing::helical_pair());
  // The control is hidden, because it does not work without the script.
  EXPECT_NE(control.find("hidden>"), control.npos);
  EXPECT_NE(control.find("type=\"range\""), control.npos);
  const std::string script(turn_script());
  EXPECT_NE(script.find("prefers-reduced-motion"), script.npos);
  EXPECT_NE(script.find("beforeprint"), script.npos);
  EXPECT_EQ(script.find("</"), script.npos);
}

}  // namespace
}  // namespace gearwright
