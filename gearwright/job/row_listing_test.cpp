// Tables with a line for each record.
#include "gearwright/job/listing.hpp"

#include <gtest/gtest.h>

namespace gearwright {
namespace {

struct Shaft {
  double length;
  std::array<double, 2> ends;
  std::optional<double> load;
};

const Quantities<Shaft>& inner_quantities() {
  static const Quantities<Shaft> kAll(
      "inner", [](Quantities<Shaft>& q) { q.number("force_N", "force", "F", "", &Shaft::load); });
  return kAll;
}

const Quantities<Shaft>& shaft_quantities() {
  static const Quantities<Shaft> kAll("shaft", [](Quantities<Shaft>& q) {
    q.number("length_mm", "length", "l", "", &Shaft::length).digits(1);
    q.number("half_mm", "length of each half", "l", "", [](const Shaft& s) {
       return s.length / 2;
     }).digits(1);
    q.number("end_mm", "end", "e", "", &Shaft::ends).per_gear().digits(2);
    q.record<inner_quantities>("inner", "",
                               [](const Shaft& s) { return inner_quantities().of(s); });
    q.whole("ratio", "ratio", "i", "", [](const Shaft& s) {
       return ValueList{Value(static_cast<int>(s.length)), Value(10)};
     }).fraction();
  });
  return kAll;
}

std::string listed(UnitSystem units, const std::vector<Shaft>& shafts) {
  std::vector<ValueRecord> records;
  for (const Shaft& s : shafts) records.push_back(shaft_quantities().of(s));
  return row_listing(units, {"first", "second, longer"}, records,
                     {"length_mm", "half_mm", "end_mm", "inner.force_N", "ratio", "unknown"});
}

// The two lengths have the same symbol, so their columns have words. No shaft has a load.
TEST(RowListing, has_a_line_for_each_record) {
  EXPECT_EQ(listed(UnitSystem::mm, {{25.4, {1, 2}, {}}, {127, {3, 4}, {}}}),
            "                          length of\n"
            "                  length  each half    e1    e2       i\n"
            "                      mm         mm    mm    mm\n"
            "  first             25.4       12.7  1.00  2.00   25/10\n"
            "  second, longer   127.0       63.5  3.00  4.00  127/10\n");
}

// A column appears if one of the records has a value. The key of an inner record follows a dot.
TEST(RowListing, shows_a_column_that_one_record_fills) {
  const std::string text = listed(UnitSystem::mm, {{10, {1, 2}, {}}, {20, {3, 4}, 7.0}});
  EXPECT_NE(text.find("  F"), std::string::npos) << text;
  EXPECT_NE(text.find("2.00    -  10/10"), std::string::npos) << text;
  EXPECT_NE(text.find("4.00  7.0  20/10"), std::string::npos) << text;
}

TEST(RowListing, converts_to_inch) {
  const std::string text = listed(UnitSystem::inch, {{25.4, {1, 2}, {}}, {127, {3, 4}, {}}});
  EXPECT_NE(text.find("    in"), std::string::npos) << text;
  EXPECT_EQ(text.find("mm"), std::string::npos) << text;
  EXPECT_NE(text.find("  first             1.00"), std::string::npos) << text;
}

}  // namespace
}  // namespace gearwright
