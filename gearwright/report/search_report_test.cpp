#include "gearwright/report/search_report.hpp"

#include <gtest/gtest.h>

#include <string>

#include "gearwright/design/testing/found_designs.hpp"
#include "gearwright/figure/markup.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/testing/page_text.hpp"
#include "gearwright/report/testing/sample_search.hpp"
#include "gearwright/report/testing/strict_html.hpp"

namespace gearwright {
namespace {

using testing::count_of;
using testing::has;
using testing::SearchSample;

TEST(SearchReport, PagesAreSoundAndReachNothingElse) {
  for (const SearchSample& sample : testing::all_searches()) {
    const std::string page = search_report(sample.report());
    const auto facts = testing::StrictHtml::read(page);
    for (const std::string& fault : facts.faults) ADD_FAILURE() << fault;
    for (const std::string& link : facts.links) EXPECT_EQ(link.substr(0, 1), "#") << link;
    for (const char* reach :
         {"http:", "https:", "@import", "src=", "url(\"", "url('", "fetch(", "XMLHttp"})
      EXPECT_FALSE(has(page, reach)) << reach;
    const std::string body = page.substr(page.find("<body>"), page.find("<script>"));
    EXPECT_FALSE(has(body, "nan"));
    EXPECT_EQ(page, search_report(sample.report()));
  }
}

TEST(SearchReport, CountsInWords) {
  const SearchSample sample = testing::spur_search();
  const std::string page = search_report(sample.report());
  EXPECT_TRUE(has(page,
                  "2\u202f754 combinations of module and numbers of teeth were tried, and 56 of "
                  "them satisfy"));
  EXPECT_TRUE(has(page,
                  "<th scope=\"row\">centre distance out of reach</th><td "
                  "class=\"value\">2\u202f698</td>"));
  EXPECT_FALSE(has(page, "specific sliding too great"));  // this limit rejected no trial
  const DesignRow& best = sample.answer->designs.front();
  EXPECT_TRUE(has(page, "contact ratio " + fixed(best.contact_ratio, 3) + "."));
  EXPECT_TRUE(has(page, "All 56 designs, sorted by contact ratio"));
  EXPECT_TRUE(has(search_report(sample.report(30)), "The best 30 of 56"));
}

TEST(SearchReport, TheBestTwentyHaveTheirRegions) {
  const SearchSample sample = testing::spur_search();
  const std::string page = search_report(sample.report());
  for (int i = 1; i <= 20; ++i) {
    EXPECT_TRUE(has(page, "id=\"region-" + std::to_string(i) + "\""));
    EXPECT_TRUE(has(page, "href=\"#design-" + std::to_string(i) + "\""));
  }
  EXPECT_FALSE(has(page, "id=\"region-21\""));
  for (const char* picture :
       {"id=\"region\"", "id=\"designs-plot\"", "id=\"chart-limits\"", "id=\"chart-identical\""})
    EXPECT_EQ(count_of(page, picture), 1u) << picture;
  // The page has fewer rows here. No picture links to a row that is not in the table.
  const std::string few = search_report(sample.report(5));
  EXPECT_EQ(count_of(few, "href=\"#design-"), 5u);
}

TEST(SearchReport, WhenNothingFitsItSaysWhy) {
  const SearchSample sample = testing::empty_search();
  SearchReport report = sample.report();
  report.title.clear();
  report.reasons = {{"no pair <is> so small & near"}, {"center_distance_mm = 17.5", true}};
  const std::string page = search_report(report);
  for (const std::string& fault : testing::StrictHtml::read(page).faults) ADD_FAILURE() << fault;
  EXPECT_TRUE(has(page, "none of them satisfy"));
  EXPECT_TRUE(has(page, ">Why no design is feasible</h2>"));
  EXPECT_TRUE(
      has(page, "<li>no pair &lt;is&gt; so small &amp; near</li>\n<ul>\n<li>center_distance"));
  EXPECT_TRUE(has(page, "Design search, ratio 1.9 … 2.1"));
  EXPECT_FALSE(has(page, "<table class=\"designs\""));
  EXPECT_FALSE(has(page, "id=\"region"));
  EXPECT_FALSE(has(page, "id=\"designs-plot\""));
  EXPECT_TRUE(has(page, "id=\"chart-limits\""));
}

TEST(SearchReport, TextIsTextWhateverItContains) {
  const SearchSample sample = testing::exact_search();
  SearchReport report = sample.report();
  report.title = "<script>alert(\"1\")</script>";
  report.spec_text = "title = \"</pre><b>\"\n";
  const std::string page = search_report(report);
  for (const std::string& fault : testing::StrictHtml::read(page).faults) ADD_FAILURE() << fault;
  EXPECT_FALSE(has(page, "alert(\"1\")"));
  EXPECT_FALSE(has(page, "</pre><b>"));
  EXPECT_TRUE(has(page, "<pre>title = &quot;&lt;/pre&gt;&lt;b&gt;&quot;\n</pre>"));
}

// Every sentence at the foot of the page agrees with the columns of the table. If the search is
// rated, the table has safeties. If the designs have allowances, the table has the backlash at both
// ends of the tolerances.
TEST(SearchReport, FootStatesWhatTheNumbersInclude) {
  using Backlash = std::array<double, 2>;
  const auto page_of = [](bool rated, const std::optional<Backlash>& backlash) {
    SearchProblem p = testing::spur_problem();
    p.modules = {5};
    p.helix = {Angle()};
    if (rated) p.rating = testing::search::load(120.0);
    if (rated) p.objectives = {Objective::safety, Objective::noise};
    p.allowances.backlash = backlash;
    return search_report(testing::search_sample(p).report());
  };
  const std::string plain = "Manufacturing deviations, load and strength are not considered.";
  EXPECT_TRUE(has(page_of(false, std::nullopt), plain));
  for (const bool rated : {false, true}) {
    // Equal ends are an allowance without a tolerance.
    for (const auto& backlash : {std::optional<Backlash>(), std::optional(Backlash{0.1, 0.1}),
                                 std::optional(Backlash{0.1, 0.2})}) {
      const std::string page = page_of(rated, backlash);
      const bool toleranced = backlash && (*backlash)[0] < (*backlash)[1];
      EXPECT_EQ(has(page, plain), !rated && !toleranced);
      EXPECT_EQ(has(page, symbol_html("S_H1")), rated);
      EXPECT_EQ(has(page,
                    "Strength is rated by ISO 6336:2006. Load is considered only in this rating "
                    "and in the transmission error under load."),
                rated);
      EXPECT_EQ(has(page, "the ends of the tolerances of the tooth thicknesses, and"), toleranced);
      EXPECT_EQ(has(page, "includes no manufacturing deviations."), rated && !toleranced);
    }
  }
}

TEST(SearchReport, SeveralObjectivesAreSaid) {
  const std::string page = search_report(testing::pareto_search().report());
  EXPECT_TRUE(has(page,
                  "the Pareto front over size m²(z₁² + z₂²), contact ratio and area of the "
                  "region of profile shifts come first"));
  EXPECT_TRUE(has(page, "The best design by size"));
}

}  // namespace
}  // namespace gearwright
