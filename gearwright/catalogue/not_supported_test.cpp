#include "gearwright/catalogue/key_hint.hpp"

#include <gtest/gtest.h>

#include <string>

#include "gearwright/catalogue/spec_keys.hpp"

namespace gearwright {
namespace {

TEST(NotSupported, a_number_in_a_path_is_any_and_a_star_any_table) {
  EXPECT_FALSE(not_supported("gear3").empty());
  EXPECT_FALSE(not_supported("gear12").empty());
  EXPECT_FALSE(not_supported("gear1.form", "\"rack\"").empty());
  EXPECT_FALSE(not_supported("gear2.form", "\"bevel\"").empty());
  EXPECT_FALSE(not_supported("gear1.cone_angle_deg").empty());
  EXPECT_FALSE(not_supported("gear1.bore.shape").empty());
  EXPECT_TRUE(not_supported("units").empty());  // a known key
  EXPECT_FALSE(not_supported("gear1.rack.units").empty());
  for (const char* path : {"", "gear", "gears", "gear3x", "gear1.forms", "myunits", "gear1.rack"})
    EXPECT_TRUE(not_supported(path).empty()) << path;
}

TEST(NotSupported, a_power_in_hp_is_converted) {
  for (const char* key : {"rating.power_hp", "drive.power_hp", "rating.horsepower"})
    EXPECT_EQ(not_supported(key),
              "is not a key; give the power by power_kW, which is 0.7457 times the power in hp");
}

TEST(NotSupported, a_deviation_of_the_axes_is_converted) {
  for (const char* key : {"errors.crossing_um", "errors.misalignment_mm", "errors.parallelism_um"})
    EXPECT_NE(not_supported(key).find("0.01 mm over 100 mm is 0.00573°"), std::string::npos) << key;
  EXPECT_TRUE(not_supported("errors.crossing_deg").empty());
}

TEST(NotSupported, a_value_may_be_refused_where_the_key_is_known) {
  EXPECT_FALSE(not_supported("gear1.teeth", "0").empty());
  EXPECT_FALSE(not_supported("compensate.aim", "\"percentile\"").empty());
  EXPECT_TRUE(not_supported("gear1.teeth", "17").empty());
  EXPECT_TRUE(not_supported("gear1.teeth").empty());
}

// No row of the table names a key that the spec accepts. When a key becomes supported, its row must
// be deleted.
TEST(NotSupported, no_known_key_is_refused) {
  for (const Key& key : spec_keys().keys) {
    const std::string top(key.key);
    if (!top.starts_with("gear")) {
      EXPECT_TRUE(not_supported(top).empty()) << top;
    }
    for (const auto table : key.tables) {
      for (const Key& inner : table().keys) {
        const std::string path = top + "." + std::string(inner.key);
        EXPECT_TRUE(not_supported(path).empty()) << path;
        for (const auto deeper : inner.tables)
          for (const Key& innermost : deeper().keys) {
            const std::string longer = path + "." + std::string(innermost.key);
            EXPECT_TRUE(not_supported(longer).empty()) << longer;
          }
      }
    }
  }
}

}  // namespace
}  // namespace gearwright
