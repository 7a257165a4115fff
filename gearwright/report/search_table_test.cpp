#include "gearwright/report/search_table.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <vector>

#include "gearwright/report/html_text.hpp"
#include "gearwright/report/testing/sample_search.hpp"
#include "gearwright/report/testing/strict_html.hpp"

namespace gearwright {
namespace {

using testing::count_of;
using testing::SearchSample;

struct Cell {
  std::string key, text;
};

// Returns the cells of row `n`, including the rank.
std::vector<Cell> cells(const std::string& table, int n) {
  const std::size_t at = table.find("<tr id=\"design-" + std::to_string(n) + "\"");
  if (at == table.npos) return {};
  const std::string row = table.substr(at, table.find("</tr>", at) - at);
  std::vector<Cell> found;
  for (auto from = row.find("data-v=\""); from != row.npos;
       from = row.find("data-v=\"", from + 1)) {
    const std::size_t key = from + 8;
    const std::size_t text = row.find('>', key) + 1;
    found.push_back(
        {row.substr(key, row.find('"', key) - key), row.substr(text, row.find('<', text) - text)});
  }
  return found;
}

std::string table_of(const SearchSample& sample, std::size_t rows = 200) {
  return design_table(sample.search->problem(), *sample.answer, rows, UnitSystem::mm);
}

TEST(SearchTable, ARowIsItsDesign) {
  const SearchSample sample = testing::spur_search();
  const std::string table = table_of(sample);
  for (int n : {1, 20, 56}) {
    const DesignRow& row = sample.answer->designs[n - 1];
    const auto c = cells(table, n);
    ASSERT_EQ(c.size(), 21u);
    EXPECT_EQ(c[0].text, std::to_string(n));
    EXPECT_EQ(c[1].text, row.interference ? "yes" : "");
    EXPECT_EQ(c[3].text, std::to_string(row.trial.z1));
    EXPECT_EQ(c[4].text, std::to_string(row.trial.z2));
    EXPECT_EQ(c[6].text, fixed(row.ratio - 2.0, 4));
    EXPECT_EQ(c[7].text, fixed(row.center_distance, 4));
    EXPECT_EQ(c[8].text, fixed(row.shift[0], 4));
    EXPECT_EQ(c[9].text, fixed(row.shift[1], 4));
    EXPECT_EQ(c[10].text, row.balanced ? "balanced" : "middle");
    EXPECT_EQ(c[11].text, fixed(row.contact_ratio, 3));
    EXPECT_EQ(c[12].text, fixed(row.contact_ratio_true, 3));
    EXPECT_EQ(c[13].text, fixed(row.working_angle.deg(), 3));
    EXPECT_EQ(c[14].text, fixed(row.backlash_normal, 4));
    EXPECT_EQ(c[15].text, fixed(row.tip_thickness[0], 3));
    EXPECT_EQ(c[17].text, fixed(row.tip_clearance[0], 3));
    EXPECT_EQ(c[18].text, fixed(row.tip_clearance[1], 3));
    EXPECT_EQ(c[19].text, fixed(row.max_sliding(), 3));
    EXPECT_EQ(c[20].text, fixed(row.area, 4));
    // The table sorts by more digits than it shows.
    EXPECT_NEAR(std::stod(c[11].key), row.contact_ratio, 1e-11);
    EXPECT_EQ(c[19].key.empty(), !row.max_sliding());
  }
}

TEST(SearchTable, ColumnsThatSayNothingAreLeftOut) {
  const std::string spur = table_of(testing::spur_search());
  EXPECT_EQ(spur.find("helix angle"), spur.npos);
  EXPECT_EQ(spur.find("overlap ratio"), spur.npos);
  EXPECT_EQ(spur.find("Pareto"), spur.npos);
  const std::string helical = table_of(testing::helical_search());
  EXPECT_NE(helical.find("title=\"overlap ratio"), helical.npos);
  EXPECT_NE(helical.find("helix angle"), helical.npos);
  const std::string crossed = table_of(testing::crossed_search());
  EXPECT_NE(crossed.find("title=\"working normal pressure angle"), crossed.npos);
  EXPECT_EQ(crossed.find("overlap ratio"), crossed.npos);
}

TEST(SearchTable, InterferenceComesFirstAndOnlyWhereSomethingInterferes) {
  const std::string flagged = design_table_key(testing::spur_search().search->problem(),
                                               *testing::spur_search().answer, 200, UnitSystem::mm);
  EXPECT_LT(flagged.find("<dt>interference</dt>"), flagged.find("normal module"));
  const SearchSample clean = testing::pareto_search();
  EXPECT_EQ(table_of(clean).find("interference"), std::string::npos);
}

// The text of the page contains no keys of result files and no equation numbers.
TEST(SearchTable, TheKeySpeaksToReadersOfThePage) {
  for (const SearchSample& sample : testing::all_searches()) {
    const std::string key =
        design_table_key(sample.search->problem(), *sample.answer, 200, UnitSystem::mm);
    for (const char* word : {"`", "[z1", "[x1", "Eq. ", "eq11", "lo_hi"})
      EXPECT_EQ(key.find(word), key.npos) << word << " in " << key;
  }
}

TEST(SearchTable, TheFrontIsMarked) {
  const SearchSample sample = testing::pareto_search();
  const std::string table = table_of(sample);
  EXPECT_GT(sample.answer->pareto.size(), 1u);
  EXPECT_EQ(count_of(table, "●"), sample.answer->pareto.size());
  EXPECT_EQ(cells(table, 1)[1].text, "●");
}

TEST(SearchTable, EveryRowHasACellForEveryHeadingAndEveryHeadingWords) {
  for (const SearchSample& sample : testing::all_searches()) {
    const std::string table = table_of(sample);
    for (const std::string& fault : testing::StrictHtml::read(testing::as_page(table)).faults)
      ADD_FAILURE() << fault;
    const std::size_t headings = count_of(table, "<th scope=\"col\"");
    EXPECT_EQ(count_of(table, "data-first=\""), headings);
    const auto n = static_cast<int>(std::min<std::size_t>(200, sample.answer->designs.size()));
    for (int i = 1; i <= n; ++i) EXPECT_EQ(cells(table, i).size(), headings);
    EXPECT_EQ(count_of(table, "<tr id="), static_cast<std::size_t>(n));
    const std::string key =
        design_table_key(sample.search->problem(), *sample.answer, 200, UnitSystem::mm);
    EXPECT_EQ(count_of(key, "<dt>"), headings - 1);  // the rank column has no explanation
    EXPECT_EQ(count_of(table, "aria-sort=\"ascending\""), 1u);
  }
}

TEST(SearchTable, NoMoreRowsThanAsked) {
  const SearchSample sample = testing::spur_search();
  EXPECT_EQ(count_of(table_of(sample, 7), "<tr id="), 7u);
  EXPECT_EQ(count_of(table_of(sample, 0), "<tr id="), 0u);
}

}  // namespace
}  // namespace gearwright
