#include "gearwright/catalogue/key_hint.hpp"

#include <gtest/gtest.h>

#include <string>

#include "gearwright/catalogue/drive_keys.hpp"
#include "gearwright/catalogue/error_keys.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/catalogue/search_keys.hpp"
#include "gearwright/catalogue/spec_keys.hpp"

namespace gearwright {
namespace {

std::string nearest(std::string_view key) { return "did you mean " + std::string(key) + "?"; }

TEST(KeyHint, what_people_try_leads_to_the_entry_that_says_so) {
  std::size_t words = 0;
  for (const KeyTable* table : all_key_tables()) {
    for (const Key& key : table->keys) {
      for (const std::string_view also : key.also) {
        ++words;
        EXPECT_FALSE(table->find(also)) << table->name << " has a key " << also;
        EXPECT_EQ(key_hint(*table, "somewhere", also), nearest(key.key))
            << table->name << ": " << also;
      }
    }
  }
  EXPECT_GT(words, 60u);
}

// [pair] cannot be combined with a search of drives, and the key `cutter` belongs to racks of arcs.
TEST(KeyHint, a_key_that_fits_is_suggested_before_a_namesake) {
  EXPECT_EQ(key_hint(drive_search_keys(), "search", "center_distance"),
            nearest("center_distance_mm"));
  EXPECT_EQ(key_hint(gear_keys(), "gear2", "cutter"), nearest("cut_by"));
}

TEST(KeyHint, one_letter_of_a_long_key_may_be_anything) {
  for (const KeyTable* table : all_key_tables()) {
    for (const Key& key : table->keys) {
      if (key.key.size() < 14) continue;
      std::string slip(key.key);
      slip[1] = slip[1] == 'q' ? 'w' : 'q';
      EXPECT_EQ(key_hint(*table, "somewhere", slip), nearest(key.key)) << table->name;
    }
  }
}

TEST(KeyHint, where_nothing_is_near_the_table_says_what_it_has) {
  for (const char* key : {"", "_", "smoothness", "xylophone"})
    EXPECT_TRUE(key_hint(pair_keys(), "pair", key)
                    .starts_with("the known keys of this table are center_distance"))
        << key;
  EXPECT_EQ(key_hint(pair_keys(), "pair", std::string(100'000, 'x')).find("nearest"),
            std::string::npos);
}

TEST(KeyHint, a_word_that_only_looks_similar_is_no_suggestion) {
  EXPECT_EQ(key_hint(gear_keys(), "gear1", "hub_diameter_mm").find("did you mean"),
            std::string::npos);
  EXPECT_EQ(key_hint(spec_keys(), "", "gear"), nearest("gear1"));
}

TEST(KeyHint, a_table_of_the_spec_is_no_key_of_a_gear) {
  EXPECT_EQ(key_hint(gear_keys(), "gear2", "pair"),
            "[pair] is a separate table and not a part of [gear2]");
}

TEST(KeyHint, a_key_of_this_table_needs_no_place) {
  for (const char* key : {"module", "pressure_angle", "width", "torque"})
    EXPECT_EQ(key_hint(planetary_keys(), "planetary", key).find(" in ["), std::string::npos) << key;
  EXPECT_EQ(key_hint(planetary_keys(), "planetary", "module"), nearest("normal_module_mm"));
}

TEST(KeyHint, a_word_of_the_drawing_leads_to_the_gear_before_the_search) {
  EXPECT_EQ(key_hint(pair_keys(), "pair", "thickness_series"),
            nearest("thickness_series in [gear1.tolerance]"));
  EXPECT_EQ(key_hint(search_keys(), "search", "thickness_seri"), nearest("thickness_series"));
}

// The symbol L of the bearing span is not meant.
TEST(KeyHint, the_same_spelling_elsewhere_precedes_a_symbol) {
  EXPECT_EQ(key_hint(root_fillet_keys(), "gear1.root_fillet", "l_mm"),
            nearest("l_mm in [gear1.tip_fillet]"));
}

TEST(KeyHint, a_misalignment_of_the_errors_is_a_shaft_deviation) {
  EXPECT_EQ(key_hint(error_keys(), "errors", "misalignment_um"), nearest("crossing_deg"));
}

TEST(KeyHint, a_gear_by_its_name_is_a_table_of_the_spec) {
  EXPECT_EQ(similar_key(spec_keys(), "", "pinion"), "gear1");
  EXPECT_EQ(similar_key(spec_keys(), "", "wheel"), "gear2");
  EXPECT_EQ(similar_key(search_keys(), "search", "SF"), "safety_root_min");
  EXPECT_EQ(similar_key(gear_keys(), "gear1", "xylophone"), std::nullopt);
}

TEST(KeyHint, micrometres_are_no_diametral_pitch) {
  EXPECT_EQ(key_hint(error_keys(), "errors", "pitch_um").find("diametral"), std::string::npos);
}

TEST(KeyHint, greek_letters_are_written_out) {
  EXPECT_EQ(folded("α_n"), "alphan");
  EXPECT_EQ(folded("h_aP*"), "hap");
  EXPECT_EQ(folded("Face-Width mm"), "facewidthmm");
  EXPECT_EQ(key_hint(gear_keys(), "gear1", "β"), nearest("helix_angle_deg"));
}

}  // namespace
}  // namespace gearwright
