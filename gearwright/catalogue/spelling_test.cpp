// Texts about the members of structs are rewritten for the user of a file: the keys of the file
// replace the names of the members. A second replacement changes nothing, and other words are
// unchanged.
#include "gearwright/catalogue/spelling.hpp"

#include <gtest/gtest.h>

#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/catalogue/spec_keys.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"

namespace gearwright {
namespace {

TEST(Spelling, members_become_keys) {
  for (const auto& [member, key] : {
           std::pair{"gear1.teeth", "gear1.teeth"},
           {"gear1.normal_module", "gear1.normal_module_mm"},
           {"gear2.rack.dedendum", "gear2.rack.dedendum"},
           {"gear2.rack.semi_topping_angle", "gear2.rack.semi_topping_angle_deg"},
           {"gear1.rack.concave_radius", "gear1.rack.concave_radius"},
           {"gear1.rack.arcs[2]", "gear1.rack.arcs[2]"},
           {"gear1.rack.arcs[2].begin", "gear1.rack.arcs[2].begin_deg"},
           {"gear2.cut_by.tip_fillet.radius", "gear2.cut_by.tip_fillet.radius_mm"},
           {"gear1.basic.base_diameter", "gear1.basic.base_diameter_mm"},
           {"gear1.measure.chord_diameter", "gear1.measure.chord_diameter_mm"},
           {"gear1.bore.keyway_width", "gear1.bore.keyway_width_mm"},
           {"pair.center_distance", "pair.center_distance_mm"},
           {"errors.cutter_lead[0]", "errors.cutter_lead1_deg"},
           {"errors.helix_twist[1]", "errors.helix_slope2_um"},
           {"fit.working_normal_pressure_angle", "fit.working_normal_pressure_angle_deg"},
           {"search.limits.contact_ratio", "search.contact_ratio_min"},
           {"search.limits.min_shift", "search.profile_shift"},
           {"gear1.modifications.lead_slope", "gear1.modifications.lead_slope_um"},
           {"gear1", "gear1"},
           {"--out", "--out"},
           {"profile_shift", "profile_shift"},
           {"gear1.normal_module_mm", "gear1.normal_module_mm"},
       }) {
    EXPECT_EQ(spelled_member("", member).key, key);
    EXPECT_EQ(spelled_member("", key).key, key) << "twice";
  }
}

// A member of a search may belong to [search] or to another table, and only words are in quotes.
TEST(Spelling, a_member_is_searched_in_its_table_and_then_in_the_spec) {
  const auto shown = [](const char* member, const char* value) {
    const auto [key, text] = spelled_member("search", member, value);
    return key + " = " + text;
  };
  EXPECT_EQ(shown("limits.contact_ratio", "1.2"), "search.contact_ratio_min = 1.2");
  EXPECT_EQ(shown("limits.avoid_interference", "flag"), "search.interference = \"flag\"");
  EXPECT_EQ(shown("coprime", "true"), "search.coprime = true");
  EXPECT_EQ(shown("rating.torque", "80"), "rating.torque_Nm = 80");
  EXPECT_EQ(shown("gear1.material.name", "34CrMo4"), "gear1.material.name = \"34CrMo4\"");
}

// If a spec contains a key, an error about a member that this key sets names this key.
TEST(Spelling, every_key_is_found_by_its_member) {
  for (const Key& table : spec_keys().keys) {
    if (table.tables.empty()) continue;
    for (const Key& key : table.tables.front()().keys) {
      for (const std::string& member : key.members()) {
        const std::string path = std::string(table.key) + "." + std::string(key.key);
        const Error error{std::string(table.key) + "." + member, "", ""};
        EXPECT_EQ(spelled(error, {path}).field, path);
      }
    }
  }
}

TEST(Spelling, the_key_that_was_given_counts) {
  const GivenKeys pitch{"gear1", "gear1.normal_diametral_pitch_per_in"};
  EXPECT_EQ(
      spelled({"gear1.normal_module", "0.0008", "must lie between 0.001\u00a0mm and 1000\u00a0mm"},
              pitch)
          .message(),
      "gear1.normal_diametral_pitch_per_in: this value gives normal_module_mm = 0.0008: must lie "
      "between 0.001\u00a0mm and 1000\u00a0mm");
  const Error flank{"gear1.modifications.left.tip_relief.amount", "900", "is too much"};
  EXPECT_EQ(spelled(flank, {"gear1.modifications.left_tip_relief_um"}).message(),
            "gear1.modifications.left_tip_relief_um = 900: is too much");
  EXPECT_EQ(spelled(flank, {"gear1.modifications.tip_relief_um"}).message(),
            "gear1.modifications.tip_relief_um = 900: is too much");
  EXPECT_EQ(spelled(flank).message(), "gear1.modifications.tip_relief_um = 900: is too much");
  // A sentence about one flank names the key of this flank, or the key of both flanks.
  const Error longer{"gear1.modifications.left.tip_relief.amount", "999",
                     "give a longer relief (`tip_relief.reach`)"};
  EXPECT_EQ(spelled(longer).rule, "give a longer relief (tip_relief_start_mm)");
  EXPECT_EQ(spelled(longer, {"gear1.modifications.left_tip_relief_start_mm"}).rule,
            "give a longer relief (left_tip_relief_start_mm)");
}

TEST(Spelling, words_stand_in_quotes_as_in_a_file) {
  EXPECT_EQ(spelled({"pair.mounting", "extended", "no"}).message(),
            "pair.mounting = \"extended\": no");
  EXPECT_EQ(spelled({"gear2.cut_by", "gear1", "no"}).value, "\"gear1\"");
  EXPECT_EQ(spelled({"gear2.cut_by", "\"gear1\"", "no"}).value, "\"gear1\"");
  EXPECT_EQ(spelled({"pair.shorten_tips", "true", "no"}).value, "true");
  EXPECT_EQ(spelled({"gear2.cut_by", "true", "no"}).value, "true");
  EXPECT_EQ(spelled({"gear1.normal_module", "nan", "no"}).value, "nan");
}

TEST(Spelling, sentences_name_the_nearest_table) {
  EXPECT_EQ(spelled({"gear1.rack.semi_topping_angle", "45", "needs `tool_addendum`"}).rule,
            "needs tool_addendum");
  EXPECT_EQ(spelled({"gear2.rack.protuberance", "1", "at `protuberance_angle` = 10 it ends"}).rule,
            "at protuberance_angle_deg = 10 it ends");
  EXPECT_EQ(spelled({"gear2.profile_shift", "", "or give `pair.center_distance`"}).rule,
            "or give pair.center_distance_mm");
  EXPECT_EQ(spelled({"gear2.tip_fillet.clearance", "", "give `radius` or `l` here"}).rule,
            "give radius_mm or l_mm here");
  EXPECT_EQ(spelled({"gear2", "", "a pair needs a second gear, `gear2`"}).rule,
            "a pair needs a second gear, [gear2]");
  EXPECT_EQ(spelled("shorten it by `tip_diameter`", {}, "gear1"), "shorten it by tip_diameter_mm");
  EXPECT_EQ(spelled("a `tick, and `what is` no member"), "a tick, and what is` no member");
  EXPECT_EQ(spelled(""), "");
}

// One sentence of the library serves a programmer, with members, and the user of a file, with keys.
TEST(Spelling, one_sentence_for_both) {
  CylindricalSpec spec = testing::plain_spec({.teeth = 20, .module = 2.0, .face_width = 10.0});
  spec.straight_rack().semi_topping_angle = Angle::degrees(45);
  const auto gear = make_gear(spec);
  ASSERT_FALSE(gear);
  EXPECT_EQ(gear.error().message(),
            "rack.semi_topping_angle = 45: needs `tool_addendum`, the height above the datum line "
            "at which the ramp starts");
  EXPECT_EQ(spelled(within("gear1", gear.error())).message(),
            "gear1.rack.semi_topping_angle_deg = 45: needs tool_addendum, the height above the "
            "datum line at which the ramp starts");
}

}  // namespace
}  // namespace gearwright
