// Every CSS class on a page occurs in its style sheet or in its scripts.
#include "gearwright/report/page_parts.hpp"

#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>

#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/report/report_sections.hpp"
#include "gearwright/report/search_table.hpp"
#include "gearwright/report/testing/sample_load.hpp"
#include "gearwright/report/testing/sample_reports.hpp"
#include "gearwright/report/testing/sample_search.hpp"

namespace gearwright {
namespace {

std::set<std::string> classes_of(const std::string& page) {
  constexpr std::string_view kClass = " class=\"";
  std::set<std::string> names;
  for (std::size_t at = page.find(kClass); at != page.npos; at = page.find(kClass, at + 1)) {
    const std::size_t from = at + kClass.size();
    std::istringstream words(page.substr(from, page.find('"', from) - from));
    for (std::string word; words >> word;) names.insert(word);
  }
  return names;
}

// Classes without a style. They mark sections, or parts that other programs read.
const std::set<std::string> kPlain{"green", "pair",  "compensate", "scatter",
                                   "front", "words", "shade",      "circle-name"};

void expect_known(const std::string& page, const std::string& what) {
  const std::string known = std::string(figure_style()) + std::string(page_style()) +
                            std::string(search_style()) + std::string(figure_script()) +
                            std::string(zoom_script()) + std::string(page_script()) +
                            std::string(turn_script()) + std::string(sort_script());
  for (const std::string& name : classes_of(page)) {
    if (kPlain.count(name) != 0) continue;
    EXPECT_NE(known.find("." + name), known.npos) << "class " << name << " of " << what;
  }
}

TEST(Contents, links_every_heading_of_a_long_page) {
  const std::string four = "<h2>A</h2>1<h2>B &amp; C</h2>2<h2>D</h2>3<h2>E</h2>4";
  EXPECT_EQ(with_contents(four).find("<nav"), 0U);
  EXPECT_NE(with_contents(four).find("<a href=\"#part-2\">B &amp; C</a>"), std::string::npos);
  EXPECT_NE(with_contents(four).find("3<h2 id=\"part-4\">E</h2>4"), std::string::npos);
  EXPECT_EQ(with_contents("<h2>A</h2>1").find("<nav"), std::string::npos);
  EXPECT_EQ(with_contents("no heading"), "no heading");
}

TEST(PageStyle, KnowsEveryClassOfEveryPage) {
  expect_known(report_html(testing::report_input(testing::helical_pair())), "helical");
  expect_known(report_html(testing::report_input(testing::undercut_pair())), "undercut");
  expect_known(report_html(testing::report_input(testing::two_and_sixty())), "two teeth");
  expect_known(report_html(testing::report_input(testing::internal_pair())), "internal");
  for (const CrossedPair& pair : testing::crossed_pairs())
    expect_known(report_html(testing::report_input(pair)), "crossed");
  for (const testing::SearchSample& sample : testing::all_searches())
    expect_known(search_report(sample.report()), "search");
  const auto load = testing::load_sample(testing::helical_pair(), {77e3, 99e3}, 0.01);
  expect_known(load_section(load.report, {"gear1", "gear2"}), "load");
}

}  // namespace
}  // namespace gearwright
