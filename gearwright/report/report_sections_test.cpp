#include "gearwright/report/report_sections.hpp"

#include <gtest/gtest.h>

#include <string>

#include "gearwright/catalogue/error_keys.hpp"
#include "gearwright/report/testing/strict_html.hpp"

namespace gearwright {
namespace {

ContactScore score(double arcsec) {
  ContactScore s;
  s.peak_to_peak = Angle::arcseconds(arcsec);
  return s;
}

// The input names the errors of a range by the keys of the spec. The report contains words and
// units instead.
TEST(CompensateSection, NamesTheErrorsOfARangeInWords) {
  CompensateView view;
  view.before = score(3.0);
  view.after = score(2.0);
  view.corrections = {
      {"gear1.lead_crowning_um", "um", "helix crowning of gear 1", 3.56, "", false}};
  const std::vector<ErrorValue> corner{{error_index("crossing_deg").value(), -0.01},
                                       {error_index("center_distance_mm").value(), 0.02}};
  view.scenarios = {{{}, score(1.5), score(1.6)}, {corner, score(3.0), score(2.0)}};
  EXPECT_EQ(errors_text(corner), "crossing_deg = -0.01, center_distance_mm = 0.02");
  const std::string text = compensate_section(view);
  EXPECT_NE(text.find(">As given<"), text.npos);
  EXPECT_NE(text.find(">Out-of-plane shaft deviation -0.01°, centre distance 0.02 mm<"), text.npos)
      << text;
  EXPECT_EQ(text.find("_deg"), text.npos);
  EXPECT_EQ(text.find("colspan=\"5\"></th>"), text.npos) << "a heading without words";
  for (const std::string& fault :
       testing::StrictHtml::read("<!DOCTYPE html>\n<div>" + text + "</div>").faults)
    ADD_FAILURE() << fault;
}

}  // namespace
}  // namespace gearwright
