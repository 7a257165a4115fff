// Tests that no two labels of a picture overlap. The test uses 200 random pairs and some difficult
// ones.
//
// Labels are read from the SVG of the page. The width of a letter is assumed to be 0.56 times the
// font size, which is near the mean of the fonts in the style. Its height is assumed to be 0.62
// times the font size. Labels that overlap by this measure appear to touch.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/figure/free_labels.hpp"
#include "gearwright/report/report_sections.hpp"
#include "gearwright/report/testing/sample_load.hpp"

namespace gearwright {
namespace {

struct Label {
  std::string words;
  PixelBox box;
};

std::string_view between(std::string_view text, std::string_view from, std::string_view to) {
  const std::size_t begin = text.find(from);
  if (begin == text.npos) return {};
  text.remove_prefix(begin + from.size());
  return text.substr(0, text.find(to));
}

double number(std::string_view text) { return std::atof(std::string(text).c_str()); }

// Returns the text without tags, and its length in letters. An entity counts as one letter, and a
// letter in a subscript as three quarters of one.
std::pair<std::string, double> plain(std::string_view markup) {
  std::string words;
  double letters = 0.0;
  bool small = false;
  for (std::size_t i = 0; i < markup.size();) {
    if (markup[i] == '<') {
      const std::size_t end = markup.find('>', i);
      small = markup.substr(i, end - i).find("class=\"s\"") != markup.npos;
      i = end + 1;
      continue;
    }
    std::size_t next = i + 1;
    if (markup[i] == '&') next = markup.find(';', i) + 1;
    while (next < markup.size() && (static_cast<unsigned char>(markup[next]) & 0xC0) == 0x80)
      ++next;
    const std::string_view letter = markup.substr(i, next - i);
    words += letter;
    if (letter != "\u200b") letters += small ? 0.75 : 1.0;
    i = next;
  }
  return {words, letters};
}

std::vector<Label> labels_of(std::string_view svg) {
  std::vector<Label> labels;
  constexpr std::string_view kStart = "<g class=\"lb\" transform=\"translate(";
  for (std::size_t at = svg.find(kStart); at != svg.npos; at = svg.find(kStart, at + 1)) {
    const std::string_view group = svg.substr(at, svg.find("</g>", at) - at);
    const std::size_t text = group.find("<text");
    if (text == group.npos) continue;
    const std::string_view place = between(group, "translate(", ")");
    const std::size_t comma = place.find_first_of(", ");
    const std::string_view tag = group.substr(text, group.find('>', text) - text);
    const std::string_view style = between(tag, "class=\"", "\"");
    const auto has = [&](std::string_view word) {
      return (" " + std::string(style) + " ").find(" " + std::string(word) + " ") !=
             std::string::npos;
    };
    const double size = has("letter") ? 14.0 : has("tick") || has("inzone") ? 12.0 : 13.0;
    const auto [words, letters] = plain(group.substr(text + tag.size() + 1));
    const double width = 0.56 * size * letters;
    const double x = number(place.substr(0, comma)) + number(between(tag, " x=\"", "\""));
    const double y = number(place.substr(comma + 1)) + number(between(tag, " y=\"", "\""));
    const double left = has("m") ? x - width / 2 : has("e") ? x - width : x;
    labels.push_back({words, {left, y - 0.62 * size, left + width, y}});
  }
  return labels;
}

void expect_no_overlap(const std::string& page, const std::string& what) {
  std::size_t pictures = 0;
  for (std::size_t at = page.find("<svg"); at != page.npos; at = page.find("<svg", at + 1)) {
    ++pictures;
    const std::string_view svg = std::string_view(page).substr(at, page.find("</svg>", at) - at);
    const std::vector<Label> labels = labels_of(svg);
    for (std::size_t i = 0; i < labels.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_FALSE(meet(labels[i].box, labels[j].box))
            << what << ": " << labels[j].words << " on " << labels[i].words << " in "
            << between(svg, "id=\"", "\"");
  }
  EXPECT_GE(pictures, 4u) << what;
}

TEST(LabelOverlap, the_test_sees_one) {
  Svg svg("x", 100, 100, "t", "d");
  svg.text({50, 50}, "d_b", Anchor::middle);
  svg.text({56, 52}, "T", Anchor::middle);
  const auto labels = labels_of(svg.str());
  ASSERT_EQ(labels.size(), 2u);
  EXPECT_TRUE(meet(labels[0].box, labels[1].box));
}

TEST(LabelOverlap, nowhere_in_random_pairs) {
  std::mt19937 random(20261122);
  const auto whole = [&](int lo, int hi) { return std::uniform_int_distribution(lo, hi)(random); };
  int pairs = 0;
  for (int k = 0; pairs < 200; ++k) {
    ASSERT_LT(k, 400);
    const bool ring = k % 5 == 0;
    const int z1 = k == 1 ? 12 : whole(9, 40);
    const int z2 = k == 1 ? 94 : ring ? -whole(z1 + 20, z1 + 90) : whole(z1, 110);
    const double helix =
        std::array{0.0, 0.0, 10.0, 20.0, 30.0}[static_cast<std::size_t>(whole(0, 4))];
    const double module = std::array{0.5, 1.0, 2.5, 8.0}[static_cast<std::size_t>(whole(0, 3))];
    const double x1 = 0.1 * whole(z1 < 17 ? 2 : -2, 6);
    const std::string what = std::to_string(z1) + ":" + std::to_string(z2) + " helix " +
                             std::to_string(helix) + " x " + std::to_string(x1);
    const auto pair = mount_as<ParallelPair>(
        testing::sample_gear(z1, module, helix, x1),
        testing::sample_gear(z2, module, ring ? helix : -helix, ring ? -x1 : 0.0), {});
    if (!pair) continue;
    ++pairs;
    expect_no_overlap(report_html(testing::report_input(*pair)), what);
  }
}

TEST(LabelOverlap, nowhere_in_the_awkward_ones) {
  expect_no_overlap(report_html(testing::report_input(testing::undercut_pair())), "undercut");
  expect_no_overlap(report_html(testing::report_input(testing::two_and_sixty())), "two teeth");
  expect_no_overlap(report_html(testing::report_input(testing::internal_pair())), "internal");
}

TEST(LabelOverlap, nowhere_under_load) {
  const std::array<std::string, 2> shapes{"gear1", "gear2"};
  for (const double torque : {3e3, 77e3, 400e3}) {
    const auto spur =
        testing::load_sample(testing::spur_pair(), {torque, 1.5 * torque, 2 * torque}, 0.01);
    expect_no_overlap(load_section(spur.report, shapes), "spur under load");
    const auto helical = testing::load_sample(testing::helical_pair(), {0.4 * torque}, 0.0);
    expect_no_overlap(load_section(helical.report, shapes), "helical under load");
  }
}

}  // namespace
}  // namespace gearwright
