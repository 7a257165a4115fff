// A key is set in a text, and the rest of the text is unchanged.
#include "gearwright/spec/spec_text.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {
namespace {

constexpr const char* kText = R"(# a pair
title = "ä pair"   # of two

[gear1]            # the pinion
teeth = 17
normal_module_mm = 2.5  # as drawn
rack = { dedendum = 1.25, tip_radius = 0.38 }

[gear2]
teeth = 40

[pair]
)";

std::string edited(const std::string& path, const std::string& value,
                   const std::string& text = kText) {
  const auto result = with_key(text, path, value);
  EXPECT_TRUE(result) << (result ? "" : result.error().message());
  return result ? *result : std::string();
}

Json read_json(const std::string& toml) {
  const auto tree = parse_spec(toml, SpecFormat::toml);
  EXPECT_TRUE(tree);
  return tree ? *tree : Json();
}

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), by);
}

TEST(EditText, a_value_changes_in_its_place) {
  EXPECT_EQ(edited("gear1.teeth", "18"), replaced(kText, "teeth = 17", "teeth = 18"));
  EXPECT_EQ(edited("gear1.normal_module_mm", "3.0"), replaced(kText, "= 2.5  #", "= 3.0  #"));
  EXPECT_EQ(edited("title", "\"x\""), replaced(kText, "\"ä pair\"", "\"x\""));
  EXPECT_EQ(edited("gear1.rack.dedendum", "1.4"), replaced(kText, "1.25", "1.4"));
  EXPECT_EQ(edited("gear1.teeth", "17"), kText);
}

TEST(EditText, a_material_that_is_only_a_name_becomes_a_table) {
  const std::string text = "[gear1]\nteeth = 17\nmaterial = \"16MnCr5\"  # case hardened\n";
  const auto named = read_json(edited("gear1.material.name", "\"42CrMo4\"", text));
  EXPECT_EQ(named["gear1"]["material"], (Json{{"name", "42CrMo4"}}));
  const auto rough = read_json(edited("gear1.material.poisson_ratio", "0.29", text));
  EXPECT_EQ(rough["gear1"]["material"], (Json{{"name", "16MnCr5"}, {"poisson_ratio", 0.29}}));
  EXPECT_EQ(edited("gear1.material.kind", "null", text), text);  // the material has no such key
}

TEST(EditText, an_absent_key_stands_at_the_end_of_its_table) {
  EXPECT_EQ(edited("gear2.face_width_mm", "20"),
            replaced(kText, "teeth = 40\n", "teeth = 40\nface_width_mm = 20\n"));
  EXPECT_EQ(edited("pair.center_distance_mm", "71.5"),
            fmt::format("{}center_distance_mm = 71.5\n", kText));
  EXPECT_EQ(edited("gear1.rack.addendum", "1.0"),
            replaced(kText, "0.38 }", "0.38, addendum = 1.0 }"));
  EXPECT_EQ(edited("errors.crossing_deg", "0.02"),
            fmt::format("{}\n[errors]\ncrossing_deg = 0.02\n", kText));
  EXPECT_EQ(edited("gear1.teeth", "20", ""), "[gear1]\nteeth = 20\n");
}

TEST(EditText, a_key_is_taken_out_with_its_line_and_a_table_with_all_of_its_own) {
  EXPECT_EQ(edited("gear1.normal_module_mm", "null"),
            replaced(kText, "normal_module_mm = 2.5  # as drawn\n", ""));
  EXPECT_EQ(edited("gear1.rack.dedendum", "null"), replaced(kText, "dedendum = 1.25, ", ""));
  EXPECT_EQ(edited("gear1.rack.tip_radius", "null"), replaced(kText, ", tip_radius = 0.38", ""));
  EXPECT_EQ(edited("gear2", "null"), replaced(kText, "[gear2]\nteeth = 40\n\n", ""));
  EXPECT_EQ(edited("gear1.helix_angle_deg", "null"), kText);
}

TEST(EditText, what_is_no_text_value_or_table_is_refused) {
  EXPECT_FALSE(with_key("[gear1\n", "gear1.teeth", "17"));
  EXPECT_FALSE(with_key(kText, "gear1.teeth", "seventeen"));
  EXPECT_FALSE(with_key(kText, "gear1.teeth.more", "17"));
}

TEST(EditText, the_tree_is_the_wanted_one_whatever_the_form) {
  for (const std::string text :
       {"gear1.teeth = 17\ngear1.rack.dedendum = 1.25\n",
        "[gear1]\nteeth = 17\n[gear1.rack]\ndedendum = 1.25\n",
        "gear1 = { teeth = 17, rack = { dedendum = 1.25 } }\n", "[gear1.rack]\ndedendum = 1.25"}) {
    const std::string after = edited("gear1.rack.addendum", "1.5", text);
    EXPECT_EQ(edited("gear1.rack.addendum", "1.5", after), after) << after;  // the sub-table exists
    EXPECT_NE(after.find("1.25"), std::string::npos) << after;
  }
}

}  // namespace
}  // namespace gearwright
