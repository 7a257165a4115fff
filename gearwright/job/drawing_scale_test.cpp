// A workshop drawing takes the greatest scale of ISO 5455 that has room, and A3 if A4 is too small.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/job/workshop_drawing.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {
namespace {

using testing::taken;

SolvedJob solved_gears(const std::string& toml) {
  return taken(solve(taken(read_spec(toml, SpecFormat::toml)), Scope::everything));
}

std::string gear1(const std::string& lines) { return "[gear1]\n" + lines + "\n"; }

TEST(DrawingScale, TakesTheGreatestScaleThatHasRoom) {
  const auto scale = [](const std::string& toml, SheetSize size) {
    return taken(workshop_sheets(solved_gears(toml), {1}, size, 0.001)).scales;
  };
  const std::string small = gear1("teeth = 60\nnormal_module_mm = 0.2\nface_width_mm = 1");
  const std::string great = gear1("teeth = 200\nnormal_module_mm = 20\nface_width_mm = 400");
  EXPECT_EQ(scale(small, SheetSize::a4), "5:1");
  EXPECT_EQ(scale(small, SheetSize::a3), "10:1");
  EXPECT_EQ(scale(great, SheetSize::a4), "1:50");
  EXPECT_EQ(scale(great, SheetSize::a3), "1:20");
}

// Without a size, the sheets are A4. They are A3 if one of them would have a scale below 1:2 on A4
// and a greater scale on A3.
TEST(DrawingScale, IsOnA3IfA4WouldBeTooSmall) {
  const auto sheets = [](const std::string& toml, const std::vector<int>& gears) {
    return taken(workshop_sheets(solved_gears(toml), gears, std::nullopt, 0.001));
  };
  const auto wheel = [](int teeth) {
    return fmt::format("\n[gear2]\nteeth = {}\nnormal_module_mm = 2\nface_width_mm = 15", teeth);
  };
  const std::string pinion = gear1("teeth = 27\nnormal_module_mm = 2\nface_width_mm = 15");
  const WorkshopSheets small = sheets(pinion + wheel(30), {1, 2});
  EXPECT_EQ(small.size, SheetSize::a4) << small.scales;
  const WorkshopSheets large = sheets(pinion + wheel(170), {1, 2});
  EXPECT_EQ(large.size, SheetSize::a3) << large.scales;
  for (const Sheet& sheet : large.sheets) EXPECT_EQ(sheet.size.x(), 420);
  EXPECT_EQ(sheets(pinion + wheel(170), {1}).size, SheetSize::a4);
}

}  // namespace
}  // namespace gearwright
