#include "gearwright/report/path_picture.hpp"

#include <gtest/gtest.h>

#include "gearwright/report/testing/sample_reports.hpp"

namespace gearwright {
namespace {

TEST(PathFigures, SaysWhereTheInvoluteEnds) {
  EXPECT_NE(path_figures(testing::undercut_pair()).find("no involute"), std::string::npos);
  EXPECT_EQ(path_figures(testing::helical_pair()).find("no involute"), std::string::npos);
}

}  // namespace
}  // namespace gearwright
