#include "gearwright/report/contact_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "gearwright/contact/testing/sample_pairs.hpp"
#include "gearwright/report/testing/sample_contact.hpp"

namespace gearwright {
namespace {

bool any(const ContactResult& result, bool (*is)(TouchKind)) {
  return std::any_of(result.positions.begin(), result.positions.end(),
                     [&](const ContactPoint& p) { return is(p.kind); });
}

void agree(const ContactResult& result) {
  const std::string words = contact_words(result);
  const auto say = [&](const char* part) { return words.find(part) != std::string::npos; };
  EXPECT_EQ(say("an edge touches"), any(result, is_edge)) << words;
  const bool ridge = any(result, [](TouchKind k) { return k == TouchKind::ridge; });
  EXPECT_EQ(say("at the start of a relief"), ridge && !any(result, is_edge)) << words;
}

TEST(ContactWords, TheStartOfAReliefIsNoEdgeOfATooth) {
  testing::SamplePair p = testing::involutes(20, 41, 12);
  FlankModifications m;
  m.lead_crowning = 0.01;
  const double lo = 2 * *p.gears[0].root_form_radius();
  const double hi = 2 * p.gears[0].tip_form_radius();
  m.tip_relief = {0.03, lo + 0.4 * (hi - lo), ReliefShape::linear};
  p.modify(1, m);
  ContactResult result = analyse_contact(p.pair(), {96, 1, 0.006});
  ASSERT_TRUE(any(result, [](TouchKind k) { return k == TouchKind::ridge; }));
  agree(result);
  std::erase_if(result.positions, [](const ContactPoint& at) { return is_edge(at.kind); });
  agree(result);
  EXPECT_NE(contact_words(result).find("no edge touches"), std::string::npos);
}

TEST(ContactWords, AgreeWithTheKindsOfThePositions) {
  for (const testing::ContactSample& s :
       {testing::helical_contact(), testing::crossed_contact(), testing::ring_contact()})
    agree(s.report.driving);
}

}  // namespace
}  // namespace gearwright
