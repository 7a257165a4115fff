// The units of all keys, for specs in inch. If the key of a table ends with a unit of length, the
// numbers in this table are in the same unit. Numbers whose own keys have a unit and pure numbers
// are exceptions.
#include <gtest/gtest.h>

#include <set>

#include "gearwright/catalogue/spec_keys.hpp"
#include "gearwright/catalogue/unit_system.hpp"

namespace gearwright {
namespace {

using Names = std::set<std::string>;

TEST(SpecUnits, keys_without_a_unit_in_tables_of_lengths) {
  Names lengths, others;
  for (const KeyTable* table : all_key_tables())
    for (const Key& key : table->keys) {
      if (!metric_unit(key.key)) continue;
      for (const auto inner : key.tables)
        for (const Key& k : inner().keys) {
          if (unit_of(k.key) != Unit::none ||
              (k.kind != KeyKind::number && k.kind != KeyKind::whole))
            continue;
          (is_in_unit_of_table(k.key) ? lengths : others).insert(std::string(k.key));
        }
    }
  EXPECT_EQ(lengths, (Names{"offset", "range"}));
  EXPECT_EQ(others, (Names{"cpk", "shape"}));
}

TEST(SpecUnits, no_number_in_mm_without_a_unit) {
  for (const KeyTable* table : all_key_tables())
    for (const Key& key : table->keys) {
      if (key.kind != KeyKind::number || unit_of(key.key) != Unit::none) continue;
      for (const char* unit : {" in mm", " in µm"})
        EXPECT_EQ(key.meaning.find(unit), std::string_view::npos) << table->name << "." << key.key;
    }
}

TEST(SpecUnits, names_of_keys) {
  EXPECT_TRUE(is_spec_key("scatter.errors.axial_mm"));
  EXPECT_TRUE(is_spec_key("gear1.lead_crowning_um"));
  EXPECT_TRUE(is_spec_key("tool_setting_mm"));
  for (const char* name : {"plate_20_mm", "p_mm", "", "scatter.groups.case_mm"})
    EXPECT_FALSE(is_spec_key(name)) << name;
}

}  // namespace
}  // namespace gearwright
