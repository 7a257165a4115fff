#include "gearwright/catalogue/columns.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "gearwright/catalogue/contact_quantities.hpp"
#include "gearwright/catalogue/gear_quantities.hpp"

namespace gearwright {
namespace {

// A point without contact whose ellipse is known, so that some columns have a value and some have
// none.
ContactPoint point() {
  ContactPoint p;
  p.kind = TouchKind::none;
  p.rotation1 = Angle::degrees(30.0);
  p.ellipse = ContactEllipse{};
  p.ellipse->semi_minor = 0.25;
  return p;
}

const RecordColumn& named(const std::vector<RecordColumn>& columns, const std::string& name) {
  return *std::find_if(columns.begin(), columns.end(),
                       [&](const RecordColumn& c) { return c.name(".") == name; });
}

TEST(Columns, ARecordComesBeforeItsOwnColumns) {
  const auto columns = columns_of(position_quantities().table());
  const auto record = std::find_if(columns.begin(), columns.end(),
                                   [](const RecordColumn& c) { return c.name(".") == "ellipse"; });
  ASSERT_NE(record, columns.end());
  EXPECT_TRUE(record->opened());
  EXPECT_EQ(record[1].name("_"), "ellipse_semi_major_mm");
  EXPECT_EQ(record[2].name("."), "ellipse.semi_minor_mm");
  EXPECT_TRUE(record[2].optional) << "the ellipse may be null";
  EXPECT_FALSE(named(columns, "rotation1_deg").optional);
}

TEST(Columns, ValuesAreAsManyAsTheWidth) {
  const auto columns = columns_of(position_quantities().table());
  const ValueRecord row = position_quantities().of(point());
  EXPECT_EQ(named(columns, "rotation1_deg").values(row).front()->number(), point().rotation1.deg());
  EXPECT_EQ(named(columns, "ellipse.semi_minor_mm").in(row)->number(), 0.25);
  EXPECT_EQ(named(columns, "ridge.gear").in(row), nullptr) << "the record has no ridge";
  const RecordColumn& line = named(columns, "line_mm");
  EXPECT_EQ(line.width(), 6u);
  for (const RecordColumn& c : columns) {
    if (c.width() == 0) continue;
    const auto values = c.values(row);
    EXPECT_EQ(values.size(), c.width()) << c.name(".");
    for (const Value* v : values) EXPECT_TRUE(!v->list()) << c.name(".");
  }
}

TEST(Columns, InnerTablesComeOnceEach) {
  const auto tables = with_inner_tables(
      {&pair_quantities().table(), &gear_quantities().table(), &pair_quantities().table()});
  EXPECT_EQ(tables.front(), &pair_quantities().table());
  for (const QuantityTable* table : tables) {
    EXPECT_EQ(std::count(tables.begin(), tables.end(), table), 1) << table->name;
    for (const QuantityInfo* info : table->list) {
      if (!info->of) continue;
      EXPECT_EQ(std::count(tables.begin(), tables.end(), &info->of()), 1) << info->key;
    }
  }
}

}  // namespace
}  // namespace gearwright
