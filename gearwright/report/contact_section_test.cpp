#include "gearwright/report/report_sections.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <limits>
#include <string_view>

#include "gearwright/figure/contact_figures.hpp"
#include "gearwright/report/testing/page_text.hpp"
#include "gearwright/report/testing/sample_contact.hpp"
#include "gearwright/report/testing/strict_html.hpp"

namespace gearwright {
namespace {

using testing::ContactSample;
using testing::StrictHtml;

void expect_sound_section(const std::string& section) {
  const auto facts = StrictHtml::read(testing::as_page(section));
  for (const std::string& fault : facts.faults) ADD_FAILURE() << fault;
  // Searches for "nan" and "inf" as separate words.
  for (const std::string_view word : {"nan", "inf"}) {
    for (std::size_t at = section.find(word); at != std::string::npos;
         at = section.find(word, at + 1)) {
      const auto letter = [&](std::size_t i) {
        return i < section.size() && std::islower(static_cast<unsigned char>(section[i]));
      };
      EXPECT_TRUE((at > 0 && letter(at - 1)) || letter(at + word.size()))
          << section.substr(at > 20 ? at - 20 : 0, 40);
    }
  }
}

TEST(ContactSection, IsWellFormedForEveryKindOfContact) {
  for (const ContactSample& s :
       {testing::helical_contact(), testing::crossed_contact(), testing::crossed_contact(true),
        testing::ring_contact(), testing::perfect_contact()})
    expect_sound_section(contact_section(s.report));
}

TEST(ContactSection, StandsInThePage) {
  const ContactSample s = testing::helical_contact();
  const ParallelPair pair = testing::helical_pair();
  ReportInput input = testing::report_input(pair);
  EXPECT_EQ(report_html(input).find("Tooth contact"), std::string::npos);
  input.contact = &s.report;
  const std::string page = report_html(input);
  EXPECT_NE(page.find(">Tooth contact</h2>"), page.npos);
  const auto facts = StrictHtml::read(page);
  for (const std::string& fault : facts.faults) ADD_FAILURE() << fault;
}

TEST(ContactSection, WhatItIsToldIsText) {
  ContactSample s = testing::helical_contact();
  s.report.errors = {{"<b>&", 1.0, "\"mm\""}};
  s.report.modifications = {"gear 1: </ul>"};
  s.report.under[0].name = "<i>";
  expect_sound_section(contact_section(s.report));
}

TEST(ContactSection, LostContactHasNoSpectrumAndSaysSo) {
  ContactSample s = testing::helical_contact();
  s.report.driving.contact_lost = true;
  s.report.driving.harmonics.clear();
  s.report.driving.positions[3].kind = TouchKind::none;
  const std::string text = contact_section(s.report);
  expect_sound_section(text);
  EXPECT_NE(text.find("no tooth pair touches"), text.npos);
  EXPECT_NE(text.find("There is no spectrum"), text.npos);
}

TEST(ContactSection, APatternUnderWhichNothingTouches) {
  ContactSample s = testing::helical_contact();
  for (double& gap : s.report.under[0].pattern.gap) gap = std::numeric_limits<double>::infinity();
  s.report.under[0].peak_to_peak = std::nullopt;
  const std::string text = contact_section(s.report);
  expect_sound_section(text);
  EXPECT_NE(text.find("no teeth touch"), text.npos);
}

// Without errors, the contact lines sweep over the whole common flank of both gears. An
// out-of-plane shaft deviation leaves a part of this flank unmarked.
TEST(ContactSection, MisalignmentLeavesAPartUnmarked) {
  const ContactSample straight = testing::perfect_contact();
  const ContactSample crossed = testing::helical_contact();
  const double all = pattern_share(straight.report.patterns[0], straight.report.marking);
  const double part = pattern_share(crossed.report.patterns[0], crossed.report.marking);
  EXPECT_GT(all, 0.85);
  EXPECT_LT(part, all - 0.05);
  EXPECT_LE(all, 1.0 + 1e-12);
}

}  // namespace
}  // namespace gearwright
