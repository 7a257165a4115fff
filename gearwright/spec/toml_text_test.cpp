// A spec that is written and read again is unchanged.
#include "gearwright/spec/json.hpp"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include "gearwright/spec/parse_spec.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {
namespace {

TEST(TomlText, reads_back_to_the_same_tree) {
  const char* text = R"(
title = "a \"quoted\" name, größer \\ than\ttabs"
[gear1]
teeth = 12
normal_module_mm = 0.1
helix_angle_deg = 62.947616771370086
profile_shift = -1e-300
[gear1.rack]
addendum = 1
dedendum = 1.25
[gear2]
teeth = 24
normal_module_mm = 0.1
[gear2.measured]
span_mm = { 3 = 19.751, 4 = 27.131 }
over_balls_mm = [{ ball_diameter_mm = 5, dimension_mm = 69.426 }]
[pair]
shorten_tips = true
)";
  const auto spec = read_spec(text, SpecFormat::toml);
  ASSERT_TRUE(spec) << spec.error().message();
  const Json tree = spec->tree->tables;
  const std::string written = toml_text(tree);
  const auto again = read_spec(written, SpecFormat::toml);
  ASSERT_TRUE(again) << again.error().message() << "\n" << written;
  EXPECT_EQ(again->tree->tables, tree) << written;
}

}  // namespace
}  // namespace gearwright
