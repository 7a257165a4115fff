#include "gearwright/report/solid.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "gearwright/report/page_parts.hpp"
#include "gearwright/report/testing/sample_reports.hpp"
#include "gearwright/report/testing/strict_html.hpp"

namespace gearwright {
namespace {

using testing::StrictHtml;

// RFC 4648, section 10.
TEST(Base64, of_the_standard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string("\xff\xfe\x00", 3)), "//4A");
}

TEST(Solid, stands_on_the_page_where_there_is_one) {
  const ParallelPair pair = testing::helical_pair();
  ReportInput input = testing::report_input(pair);
  EXPECT_EQ(report_html(input).find("id=\"solid\""), std::string::npos);
  EXPECT_EQ(report_html(input).find("webgl"), std::string::npos);
  input.solid = "glTF and so on";
  input.solid_tolerance = 0.02;
  const std::string page = report_html(input);
  const auto facts = StrictHtml::read(page);
  for (const std::string& fault : facts.faults) ADD_FAILURE() << fault;
  EXPECT_EQ(facts.elements.at("canvas"), 1);
  EXPECT_EQ(facts.elements.at("script"), 1);
  EXPECT_NE(page.find("data-glb=\"" + base64(input.solid) + "\""), std::string::npos);
  EXPECT_NE(page.find("webgl"), std::string::npos);
  // Gear 2 of an external pair turns the other way, by the ratio.
  EXPECT_NE(page.find(fmt::format("data-turns=\"-1 {:.17g}\"", 17.0 / 43.0)), std::string::npos);
}

TEST(Contents, links_every_heading_of_a_long_page) {
  const std::string four = "<h2>A</h2>1<h2>B &amp; C</h2>2<h2>D</h2>3<h2>E</h2>4";
  EXPECT_EQ(with_contents(four).find("<nav"), 0U);
  EXPECT_NE(with_contents(four).find("<a href=\"#part-2\">B &amp; C</a>"), std::string::npos);
  EXPECT_NE(with_contents(four).find("3<h2 id=\"part-4\">E</h2>4"), std::string::npos);
  EXPECT_EQ(with_contents("<h2>A</h2>1").find("<nav"), std::string::npos);
  EXPECT_EQ(with_contents("no heading"), "no heading");
}

}  // namespace
}  // namespace gearwright
