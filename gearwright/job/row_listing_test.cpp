#include "gearwright/job/listing.hpp"

#include <gtest/gtest.h>

#include <sstream>

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

// The two lengths have the same symbol, so the heads of their columns are words. No shaft has a
// load, so there is no column of loads.
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

// A design has a length, its half and twice its length, which the columns compare by their values.
const Quantities<Shaft>& design_quantities_of_test() {
  static const Quantities<Shaft> kAll("design", [](Quantities<Shaft>& q) {
    q.number("length_mm", "length", "l", "", &Shaft::length).digits(1);
    q.number("other_mm", "other length", "l_o", "", &Shaft::length).digits(1);
    q.number("back_mm", "length to the left", "l_-", "", [](const Shaft& s) {
       return -s.length;
     }).digits(1);
    q.number("length_deg", "length as an angle", "φ", "", &Shaft::length).digits(1);
    q.number("end_mm", "end", "e", "", &Shaft::ends).per_gear().digits(2);
    q.number("force_N", "force", "F", "", &Shaft::load).digits(1);
  });
  return kAll;
}

std::vector<ListingColumn> design_columns(const std::vector<Shaft>& shafts) {
  std::vector<ValueRecord> records;
  std::vector<ListingColumn> columns(1);
  for (const Shaft& s : shafts) {
    records.push_back(design_quantities_of_test().of(s));
    columns[0].cells.push_back(std::to_string(records.size()));
  }
  for (const ListingColumn& column :
       listing_columns(UnitSystem::mm, records,
                       {"length_mm", "other_mm", "back_mm", "length_deg", "end_mm", "force_N"}))
    columns.push_back(column);
  return columns;
}

// The end of gear 1 is 3 mm in both designs. "other length" and "length to the left" have the
// values of the length. The angle has the same numbers in another unit, so it is not compared.
TEST(DesignListing, lists_common_values_above_the_table) {
  EXPECT_EQ(design_listing(design_columns({{10, {3, 1}, 5.0}, {20, {3, 2}, 5.0}})),
            "Common to all designs\n"
            "  other length        l_o  equal to l\n"
            "  length to the left  l_-  opposite to l\n"
            "  end, gear 1         e1   3.00 mm\n"
            "  force               F    5.0 N\n"
            "\n"
            "        l     φ    e2\n"
            "       mm     °    mm\n"
            "  1  10.0  10.0  1.00\n"
            "  2  20.0  20.0  2.00\n");
}

// Values that differ only after the shown digits have the same text. A value that one design lacks
// is not common.
TEST(DesignListing, compares_the_shown_texts) {
  const std::string text =
      design_listing(design_columns({{10, {3, 1}, 5.0}, {20, {3.0000001, 2}, {}}}));
  EXPECT_NE(text.find("end, gear 1         e1   3.00 mm\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("force"), std::string::npos) << text;
  EXPECT_NE(text.find("1.00  5.0\n"), std::string::npos) << text;
  EXPECT_NE(text.find("2.00    -\n"), std::string::npos) << text;
}

TEST(DesignListing, shows_every_column_of_a_single_design) {
  const std::string text = design_listing(design_columns({{10, {3, 1}, 5.0}}));
  EXPECT_EQ(text.find("Common"), std::string::npos) << text;
  EXPECT_NE(text.find("  1  10.0  10.0  -10.0  10.0  3.00  1.00  5.0\n"), std::string::npos)
      << text;
}

// Twelve columns of 20 characters each do not fit. Every line has at most 110 characters, every
// value appears once, and every table names its rows.
TEST(DesignListing, continues_in_further_tables) {
  std::vector<ListingColumn> columns{{"", "", "", {"first", "second"}, true}};
  for (int i = 0; i < 12; ++i)
    columns.push_back({"",
                       "q" + std::to_string(i),
                       "",
                       {std::string(18, static_cast<char>('a' + i)), std::string("µ")}});
  const std::string text = design_listing(columns);
  std::istringstream lines(text);
  std::size_t named = 0;
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(line.size(), 110U + 12U) << line;  // each µ has two bytes
    named += line.starts_with("  first ");
  }
  EXPECT_EQ(named, 3U) << text;  // 8 characters for the name and 5 times 20 in each table
  for (int i = 0; i < 12; ++i) {
    const std::string cell(18, static_cast<char>('a' + i));
    EXPECT_NE(text.find(cell), std::string::npos);
    EXPECT_EQ(text.find(cell, text.find(cell) + 1), std::string::npos);
  }
}

TextTable samples() {
  TextTable table{"Samples", {"mean", "key in the spec"}};
  table.rows = {{"play", "mm", {"0.10", "pair.a"}, {"0.01", ""}}, {"waves", "", {"0.0", ""}, {}}};
  table.notes = {"A sentence."};
  return table;
}

// The columns are as wide as their widest text. Numbers are aligned to the right and words to the
// left.
TEST(TableListing, has_a_title_rows_with_errors_and_notes) {
  EXPECT_EQ(table_listing(samples()),
            "\nSamples\n"
            "                            key in the\n"
            "                      mean  spec\n"
            "  play  mm            0.10  pair.a\n"
            "      standard error  0.01\n"
            "  waves                0.0\n"
            "  A sentence.\n");
}

TEST(TableListing, omits_rows_of_zeros_if_the_table_permits_it) {
  TextTable table = samples();
  table.omit_zeros = true;
  table.rows.push_back({"harmonics", "", {"-0.00", ""}, {"0.1", ""}});
  const std::string text = table_listing(table);
  EXPECT_NE(text.find("\n  zero to these digits: waves, harmonics\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("\n  waves"), std::string::npos) << text;
  table.rows.back().cells[0] = "-0.01";
  EXPECT_NE(table_listing(table).find("\n  harmonics  "), std::string::npos);
}

// The units of the columns have a line of their own. Without rows, only the title and the notes
// remain.
TEST(TableListing, has_the_units_of_its_columns) {
  EXPECT_EQ(table_listing({"", {"x", "kind"}, {{"", "", {"1.0", "line"}}}, {}, {"mm", ""}}),
            "      x  kind\n"
            "     mm\n"
            "    1.0  line\n");
  EXPECT_EQ(table_listing({"Nothing", {"x"}, {}, {"No value."}}), "\nNothing\n  No value.\n");
}

}  // namespace
}  // namespace gearwright
