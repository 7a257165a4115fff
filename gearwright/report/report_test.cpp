#include "gearwright/report/report.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/catalogue/gear_quantities.hpp"
#include "gearwright/report/testing/sample_load.hpp"
#include "gearwright/report/testing/sample_reports.hpp"
#include "gearwright/report/testing/strict_html.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {
namespace {

using testing::crossed_pair;
using testing::helical_pair;
using testing::internal_pair;
using testing::report_input;
using testing::sample_gear;
using testing::sample_pair;
using testing::StrictHtml;
using testing::undercut_pair;

std::string printed(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

// Returns the values of the first table row whose heading begins with these words.
std::vector<std::string> row(const std::string& page, const std::string& words) {
  const std::size_t at = page.find("<tr><th scope=\"row\">" + words + "</th>");
  if (at == page.npos) return {"no such row"};
  const std::string line = page.substr(at, page.find("</tr>", at) - at);
  std::vector<std::string> values;
  for (std::size_t from = line.find("class=\"value\""); from != line.npos;
       from = line.find("class=\"value\"", from + 1)) {
    const std::size_t begin = line.find('>', from) + 1;
    values.push_back(line.substr(begin, line.find('<', begin) - begin));
  }
  return values;
}

using Values = std::vector<std::string>;

void expect_sound_page(const std::string& page) {
  const auto facts = StrictHtml::read(page);
  for (const std::string& fault : facts.faults) ADD_FAILURE() << fault;
  for (const std::string& link : facts.links) {
    EXPECT_TRUE(link.rfind("#", 0) == 0 || link.rfind("./", 0) == 0) << link;
  }
  for (const char* reach :
       {"http:", "https:", "@import", "src=", "url(\"", "url('", "fetch(", "XMLHttp"}) {
    EXPECT_EQ(page.find(reach), page.npos) << reach;
  }
}

TEST(StrictHtml, SeesWhatIsBroken) {
  const auto broken = [](const std::string& body) {
    return !StrictHtml::read("<!DOCTYPE html>\n" + body).faults.empty();
  };
  EXPECT_FALSE(broken("<p class=\"a\">x &amp; y<br></p>"));
  for (const char* body :
       {"<p>", "<p></b>", "a < b", "a > b", "a & b", "<p a=b></p>", "<p a=\"1\" a=\"2\"></p>",
        "<a href=\"#x\"></a>", "<p id=\"x\"></p><p id=\"x\"></p>", "a\x01"}) {
    EXPECT_TRUE(broken(body)) << body;
  }
}

// The tolerances apply to the backlash, which therefore has a value at each end. The other key
// figures have nominal values.
TEST(Report, KeyFiguresHaveTheBacklashAtBothEnds) {
  const auto pair_at = [](double distance) {
    return sample_pair(sample_gear(21, 2, 0, 0), sample_gear(40, 2, 0, 0), distance);
  };
  const ParallelPair drawn = pair_at(61.1);  // the input contains pointers to its gears
  ReportInput input = report_input(drawn);
  const auto key = [&](const std::string& words) {
    const std::string page = report_html(input);
    const std::size_t at = page.find("<dd>", page.find("<dt>" + words)) + 4;
    return page.substr(at, page.find("</dd>", at) - at);
  };
  const std::string middle = key("Backlash in the normal section");
  EXPECT_EQ(middle.find("…"), middle.npos);
  std::string both;
  for (const double distance : {61.05, 61.2}) {
    const Pair pair = pair_at(distance);
    input.pair_ends.push_back(pair_quantities().of(pair));
    both += (both.empty() ? "" : " … ") + printed(pair.involute()->mesh.backlash.normal, 4);
  }
  EXPECT_EQ(key("Backlash in the normal section"), both + " mm");
  EXPECT_EQ(key("Centre distance"), "61.1000 mm");
  EXPECT_EQ(report_html(input).find("<dt>Mass"), std::string::npos);
  input.masses = {0.4136};  // the mass of gear 2 is unknown
  EXPECT_EQ(report_html(input).find("<dt>Mass"), std::string::npos);
  input.masses = {0.4136, 1.77};
  EXPECT_EQ(key("Mass"), "0.414 / 1.77 kg");
}

// The ids of the figures at the head of a report.
Values ids_at_the_head(const std::string& page) {
  constexpr std::string_view kFigure = "<svg class=\"zoom\" id=\"";
  const std::string head = page.substr(0, page.find("</header>"));
  Values ids;
  for (std::size_t at = head.find(kFigure); at != head.npos; at = head.find(kFigure, at + 1)) {
    const std::size_t begin = at + kFigure.size();
    ids.push_back(head.substr(begin, head.find('"', begin) - begin));
  }
  return ids;
}

// Under a load, the loaded contact comes first, and the other section states that it has no load.
TEST(Report, LoadComesBeforeTheContactWithoutLoad) {
  const testing::LoadSample load = testing::load_sample(testing::spur_pair(), {100e3}, 0.0);
  const testing::ContactSample contact = testing::helical_contact();
  ReportInput input = report_input(*load.pair);
  input.contact = &contact.report;
  EXPECT_NE(report_html(input).find(">Tooth contact</h2>"), std::string::npos);
  input.load = &load.report;
  const std::string page = report_html(input);
  const std::size_t first = page.find(">Under load</h2>");
  const std::size_t second = page.find(">Tooth contact without load</h2>");
  ASSERT_NE(second, page.npos);
  EXPECT_LT(first, second);
}

TEST(Report, FiguresThatDecideAreAtTheHead) {
  const auto expect_head = [](const ReportInput& input, const Values& ids) {
    const std::string page = report_html(input);
    expect_sound_page(page);  // no id occurs twice, because the sections omit these figures
    EXPECT_EQ(ids_at_the_head(page), ids);
  };
  const ParallelPair helical = helical_pair();
  ReportInput input = report_input(helical);
  expect_head(input, {"mesh", "path", "ratios"});
  const testing::ContactSample contact = testing::helical_contact();
  input.contact = &contact.report;
  expect_head(input, {"mesh", "te", "bearing1"});
  EXPECT_EQ(StrictHtml::read(report_html(input)).ids.count("path"), 1u);

  const testing::LoadSample load = testing::load_sample(testing::spur_pair(), {100e3}, 0.0);
  ReportInput loaded = report_input(*load.pair);
  loaded.load = &load.report;
  expect_head(loaded, {"mesh", "loaded-te", "pressure1"});
  // No figure of the transmission error remains in the section, because there is only one torque.
  EXPECT_NE(report_html(loaded).find("<p>The figure is at the head of the report.</p>"),
            std::string::npos);

  // The figures of the contact of a half remain under its heading.
  ContactReport halved = contact.report;
  halved.halves = {contact.report};
  input.contact = &halved;
  expect_head(input, {"mesh", "te", "path"});

  const RackPair rack = testing::taken(mount_rack(sample_gear(20, 2, 10, 0), {.teeth = 12}));
  ReportInput of_rack = report_input(rack.pinion);
  of_rack.rack = &rack;
  expect_head(of_rack, {"mesh"});

  const auto with_arcs = [](int teeth, double beta_deg) {
    CylindricalSpec spec = testing::plain_spec(
        {.teeth = teeth, .module = 4.0, .beta_deg = beta_deg, .face_width = 60.0});
    spec.rack = *gbt12759_rack(4.0);
    return testing::taken(make_gear(spec));
  };
  const ArcPair arcs =
      testing::taken(mount_arcs(with_arcs(18, 22), with_arcs(50, -22), std::nullopt));
  ReportInput of_arcs;
  of_arcs.gears = {&arcs.gears[0], &arcs.gears[1]};
  of_arcs.pair = arcs;
  testing::judge(of_arcs, arcs.warnings);
  expect_head(of_arcs, {"contact1", "contact2"});

  const CrossedPair crossed = testing::crossed_pair();
  expect_head(report_input(crossed), {"plan", "section", "faces"});
  const testing::ContactSample at_points = testing::crossed_contact();
  const CrossedPair left_hand = testing::left_hand_pair();
  ReportInput of_crossed = report_input(left_hand);
  of_crossed.contact = &at_points.report;
  expect_head(of_crossed, {"plan", "te", "bearing1"});
  EXPECT_EQ(ids_at_the_head(report_html(report_input(testing::crossed_apart()))),
            (Values{"plan", "section"}));
  EXPECT_EQ(ids_at_the_head(report_html(report_input(sample_gear(17, 2, 0, 0)))), Values{});
}

TEST(Report, IsWellFormedAndReachesForNothing) {
  for (const ParallelPair& pair : {helical_pair(), undercut_pair(), internal_pair()}) {
    expect_sound_page(report_html(report_input(pair)));
  }
  for (const Gear& gear :
       {sample_gear(8, 2, 0, 0), sample_gear(3, 2, 0, -0.6), sample_gear(5, 2, 0, -0.8),
        sample_gear(-60, 2, 10, 0), sample_gear(20, 2, 0, 0, 0.3)}) {
    expect_sound_page(report_html(report_input(gear)));
  }
}

TEST(Report, SameInputSameBytes) {
  const std::string first = report_html(report_input(helical_pair()));
  EXPECT_EQ(first, report_html(report_input(helical_pair())));
}

TEST(Report, GearNumbersAreTheGears) {
  const ParallelPair pair = helical_pair();
  const std::string page = report_html(report_input(pair));
  // The test computes d = z m_n/cos β and d_b = d cos α_t. All other values are taken from the
  // gears.
  const double pi = std::numbers::pi;
  const double cos_beta = std::cos(15 * pi / 180);
  const double cos_t = std::cos(std::atan(std::tan(20 * pi / 180) / cos_beta));
  const double d1 = 17 * 2.5 / cos_beta;
  const double d2 = 43 * 2.5 / cos_beta;
  EXPECT_EQ(row(page, "Number of teeth"), (Values{"17", "43"}));
  EXPECT_EQ(row(page, "Reference diameter"), (Values{printed(d1, 4), printed(d2, 4)}));
  EXPECT_EQ(row(page, "Base diameter"), (Values{printed(d1 * cos_t, 4), printed(d2 * cos_t, 4)}));
  EXPECT_EQ(row(page, "Helix angle"), (Values{"15.00000", "-15.00000"}));
  EXPECT_EQ(row(page, "Hand of helix"), (Values{"right", "left"}));
  EXPECT_EQ(row(page, "Lead"),
            (Values{printed(pair.gears[0].lead, 4), printed(pair.gears[1].lead, 4)}));
  EXPECT_EQ(row(page, "Thickness allowance"), (Values{"-0.0600", "0.0000"}));
  EXPECT_EQ(row(page, "Root form diameter"),
            (Values{printed(2 * *pair.gears[0].root_form_radius(), 4),
                    printed(2 * *pair.gears[1].root_form_radius(), 4)}));
  EXPECT_EQ(row(page, "Normal tip tooth thickness"),
            (Values{printed(*pair.gears[0].tip_tooth_thickness_normal, 4),
                    printed(*pair.gears[1].tip_tooth_thickness_normal, 4)}));
}

TEST(Report, PairNumbersAreThePairs) {
  const ParallelPair pair = helical_pair();
  const std::string page = report_html(report_input(pair));
  const Mesh<double>& m = pair.mesh;
  const double degree = 180 / std::numbers::pi;
  EXPECT_EQ(row(page, "Centre distance"), (Values{"78.6056"}));
  EXPECT_EQ(row(page, "Working transverse pressure angle"),
            (Values{printed(degree * m.rack.sides[0].transverse_angle, 5),
                    printed(degree * m.rack.sides[1].transverse_angle, 5)}));
  EXPECT_EQ(row(page, "Working helix angle"),
            (Values{printed(degree * m.rack.sides[0].helix_angle, 5),
                    printed(-degree * m.rack.sides[0].helix_angle, 5)}));
  EXPECT_EQ(row(page, "Transverse contact ratio"), (Values{printed(m.path_ratio, 5)}));
  EXPECT_EQ(row(page, "Effective total contact ratio"),
            (Values{printed(pair.contact_ratio_true(), 5)}));
  EXPECT_EQ(row(page, "Normal backlash, shortest distance of the flanks"),
            (Values{printed(m.backlash.normal_base, 4)}));
  EXPECT_EQ(row(page, "Circumferential backlash"),
            (Values{printed(m.backlash.circumferential[0], 4),
                    printed(m.backlash.circumferential[1], 4)}));
  EXPECT_EQ(row(page, "Angular backlash with the mating gear fixed"),
            (Values{printed(degree * m.backlash.rotation[0], 5),
                    printed(degree * m.backlash.rotation[1], 5)}));
  EXPECT_EQ(row(page, "Tip clearance"),
            (Values{printed(pair.tip_clearance[0], 4), printed(pair.tip_clearance[1], 4)}));
  EXPECT_EQ(row(page, "<strong>E</strong> end of contact, at the tip of gear 1"),
            (Values{printed(m.rho1_E - m.rho1_C, 4), printed(m.rho1_E, 4),
                    printed(m.base_tangent_distance - m.rho1_E, 4),
                    printed(*pair.sliding_E.zeta_1, 4), printed(*pair.sliding_E.zeta_2, 4)}));
}

TEST(Report, CrossedPairNumbersAreThePairs) {
  const CrossedPair pair = crossed_pair();
  const std::string page = report_html(report_input(pair));
  const Mesh<double>& m = pair.mesh;
  EXPECT_EQ(row(page, "Shaft angle"), (Values{"90.00000"}));
  EXPECT_EQ(row(page, "Centre distance"), (Values{"50.0100"}));
  EXPECT_EQ(row(page, "Working normal pressure angle"), (Values{"18.68383"}));
  EXPECT_EQ(row(page, "Length of path of contact"), (Values{printed(pair.path_length(), 4)}));
  EXPECT_EQ(row(page, "Minimum face width for one flank"),
            (Values{printed(pair.face_widths.one_flank[0], 4),
                    printed(pair.face_widths.one_flank[1], 4)}));
  const std::string least = page.substr(page.find("Minimum centre distance, free of backlash"));
  EXPECT_EQ(row(least, "Shaft angle"), (Values{"90.01272"}));
  // The points of the path are measured along the line of action, which is inclined to the
  // transverse section by β_b1.
  const double pitch = pair.gears[0].reference().base_pitch_normal;
  const double A =
      std::stod(row(page, "<strong>A</strong> start of contact, at the tip of gear 2")[0]);
  const double D = std::stod(row(page, "<strong>D</strong> one pitch after A")[0]);
  const double E =
      std::stod(row(page, "<strong>E</strong> end of contact, at the tip of gear 1")[0]);
  const double B = std::stod(row(page, "<strong>B</strong> one pitch before E")[0]);
  EXPECT_NEAR(D - A, pitch, 1.01e-4);
  EXPECT_NEAR(E - B, pitch, 1.01e-4);
  EXPECT_NEAR(E - A, pair.path_length(), 1.01e-4);
  const auto w = flank_speeds(pair.input, m, m.rho1_E);
  EXPECT_EQ(row(page, "<strong>E</strong>"),
            (Values{printed(w.across[0], 4), printed(w.across[1], 4), printed(w.along[0], 4),
                    printed(w.along[1], 4),
                    printed(std::hypot(w.across[0] - w.across[1], w.along[0] - w.along[1]), 4)}));
}

TEST(Report, CrossedPairsSayWhatTheyAre) {
  for (const CrossedPair& pair : testing::crossed_pairs()) {
    const std::string page = report_html(report_input(pair));
    expect_sound_page(page);
    EXPECT_NE(page.find("Crossed helical gear pair, shaft angle "), page.npos);
    EXPECT_EQ(page.find("otal contact ratio"), page.npos);
    EXPECT_EQ(page.find("tips, roots, fillets and flanks keep clear"), page.npos);
    EXPECT_LT(page.size(), 250'000u);
    const auto ids = StrictHtml::read(page).ids;
    for (const char* id : {"plan", "whole", "section", "range-angle", "widths"}) {
      EXPECT_EQ(ids.count(id), 1u) << id;
    }
    for (const char* id : {"mesh", "path", "ratios"}) EXPECT_EQ(ids.count(id), 0u) << id;
    for (const char* id : {"faces", "speeds"}) EXPECT_EQ(ids.count(id) == 1, pair.flanks_meet());
    EXPECT_EQ(page.find("nan"), page.npos);
    EXPECT_EQ(page.find("inf\""), page.npos);
  }
  const CrossedPair undercut =
      testing::crossed_sample_pair(sample_gear(9, 2, 20, 0), sample_gear(24, 2, 35, 0), 55);
  const std::string page = report_html(report_input(undercut));
  EXPECT_NE(page.find("tips keep clear of roots and fillets"), page.npos);
  const CrossedPair pair = crossed_pair();
  EXPECT_NE(report_html(report_input(pair)).find("tips keep clear of roots and fillets"),
            std::string::npos);
  EXPECT_NE(report_html(report_input(pair)).find("pair, shaft angle 90°"), std::string::npos);
  EXPECT_NE(report_input(pair).verdict.headline.find("(contact ratio 1.731)"), std::string::npos);
}

TEST(Report, WhatDoesNotExistIsADash) {
  const Gear spur = sample_gear(20, 2, 0, 0);
  EXPECT_EQ(row(report_html(report_input(spur)), "Lead"), Values{"–"});
  const std::string undercut = report_html(report_input(undercut_pair()));
  EXPECT_EQ(row(undercut, "<strong>A</strong> tip of gear 2, not reached").back(), "–");
  EXPECT_EQ(row(undercut, "Active root diameter").front(), "–");
}

TEST(Report, TextIsText) {
  const ParallelPair pair = helical_pair();
  ReportInput input = report_input(pair);
  const std::string evil = "<script>alert(1)</script>\"'&\x01";
  input.title = evil;
  input.spec_text = "</pre>" + evil;
  input.verdict.headline = evil;
  input.verdict.findings.push_back({WarningCode::undercut, Level::amber, 1, evil, evil});
  input.files.push_back({"javascript:alert(1)//\"<b>", evil, evil});
  const std::string page = report_html(input);
  expect_sound_page(page);
  const auto facts = StrictHtml::read(page);
  EXPECT_EQ(facts.elements.at("script"), 1);
  EXPECT_EQ(facts.elements.at("pre"), 1);
  EXPECT_EQ(facts.elements.at("b"),
            // There is one element for the level of the verdict, and one for the level of each
            // finding.
            static_cast<int>(1 + input.verdict.findings.size()));
  EXPECT_EQ(page.find("<script>alert"), page.npos);
  EXPECT_NE(page.find("&lt;script&gt;alert(1)&lt;/script&gt;&quot;&#39;&amp;"), page.npos);
}

TEST(Report, PicturesThatApply) {
  const auto ids = [](const ReportInput& input) {
    return StrictHtml::read(report_html(input)).ids;
  };
  const ParallelPair helical = helical_pair();
  for (const char* id : {"tooth-gear1", "tooth-gear2", "mesh", "whole", "path", "ratios"}) {
    EXPECT_EQ(ids(report_input(helical)).count(id), 1u) << id;
  }
  const ParallelPair internal = internal_pair();
  EXPECT_EQ(ids(report_input(internal)).count("tooth-gear2"), 0u);
  EXPECT_EQ(ids(report_input(internal)).count("mesh"), 1u);
  EXPECT_NE(report_html(report_input(internal)).find("The internal gear has no outline"),
            std::string::npos);
  const Gear one = sample_gear(20, 2, 0, 0);
  EXPECT_EQ(ids(report_input(one)).count("mesh"), 0u);
  EXPECT_EQ(report_html(report_input(one)).find(">Pair</h2>"), std::string::npos);
}

TEST(Report, PicturesOfFewTeethAndGearsCutByGears) {
  const ParallelPair sixty = testing::two_and_sixty();
  const std::string page = report_html(report_input(sixty));
  expect_sound_page(page);
  const auto ids = StrictHtml::read(page).ids;
  for (const char* id : {"tooth-gear1", "tooth-gear2", "root-gear1", "shift1-gear1", "shift5-gear1",
                         "centrodes-before", "centrodes-after", "mesh", "whole"}) {
    EXPECT_EQ(ids.count(id), 1u) << id;
  }
  for (const char* id : {"root-gear2", "shift1-gear2"}) EXPECT_EQ(ids.count(id), 0u) << id;
  EXPECT_NE(page.find("racks and pinion cutters"), page.npos);
  EXPECT_EQ(row(page, "Number of teeth of the cutter"), (Values{"–", "2"}));
  EXPECT_EQ(row(page, "Generating centre distance"), (Values{"–", "61.3351"}));
  EXPECT_EQ(row(page, "Root fillet radius"), (Values{"0.3", "–"}));
  EXPECT_LT(page.size(), 200'000u);

  const ParallelPair ring = testing::pinion_in_cut_ring();
  const std::string in_ring = report_html(report_input(ring));
  expect_sound_page(in_ring);
  EXPECT_EQ(StrictHtml::read(in_ring).ids.count("tooth-gear2"), 1u);
  EXPECT_EQ(in_ring.find("no outline"), in_ring.npos);
  EXPECT_EQ(in_ring.find("is not checked"), in_ring.npos);
  EXPECT_EQ(in_ring.find("Roots and tips"), in_ring.npos);
}

TEST(Report, OrdinaryPairsHaveNoneOfThat) {
  const ParallelPair pair =
      sample_pair(sample_gear(17, 2, 0, 0.1), sample_gear(43, 2, 0, -0.1), 60);
  const std::string page = report_html(report_input(pair));
  for (const char* words : {"Roots and tips", "Centrodes", "pinion cutter", "id=\"root-"}) {
    EXPECT_EQ(page.find(words), page.npos) << words;
  }
  EXPECT_NE(page.find("data-turn"), page.npos);
}

TEST(Report, GearsThatDoNotExistSayWhy) {
  const Gear through = sample_gear(3, 2, 0, -0.6);
  const Gear severed = sample_gear(5, 2, 0, -0.8);
  ASSERT_TRUE(through.tooth->through_axis);
  ASSERT_TRUE(severed.tooth->severed);
  for (const Gear* gear : {&through, &severed}) {
    const std::string page = report_html(report_input(*gear));
    EXPECT_EQ(page.find("<svg class=\"zoom\""), page.npos);
    EXPECT_NE(page.find("Gear 1: there is no picture."), page.npos);
    EXPECT_NE(report_input(*gear).verdict.headline.find("cannot be made"), std::string::npos);
  }
}

TEST(Report, StaysSmall) {
  const ParallelPair pair =
      sample_pair(sample_gear(60, 2, 0, 0, 0.3), sample_gear(60, 2, 0, 0, 0.3), 120);
  const std::size_t size = report_html(report_input(pair)).size();
  EXPECT_GT(size, 20'000u);
  EXPECT_LT(size, 150'000u);
}

}  // namespace
}  // namespace gearwright
