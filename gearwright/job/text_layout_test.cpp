#include "gearwright/job/listing.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "gearwright/base/printable.hpp"

namespace gearwright {
namespace {

TEST(TextLayout, counts_characters) {
  EXPECT_EQ(character_count("ε_α"), 3U);
  EXPECT_EQ(padded("ε_α", 5), "ε_α  ");
  EXPECT_EQ(padded_left("ε_α", 5), "  ε_α");
  EXPECT_EQ(padded("longer", 3), "longer");
}

TEST(TextLayout, keeps_a_short_sentence) {
  EXPECT_EQ(wrapped("note: short"), "note: short\n");
  EXPECT_EQ(wrapped(""), "\n");
}

// 80 characters fit, and 81 do not, however many bytes they have.
TEST(TextLayout, breaks_after_80_characters) {
  const std::string word(35, 'a');
  std::string micro;
  for (int i = 0; i < 44; ++i) micro += "µ";
  EXPECT_EQ(wrapped(word + " " + micro), word + " " + micro + "\n");
  EXPECT_EQ(wrapped(word + "a " + micro), word + "a\n  " + micro + "\n");
}

// Blanks at the start move all lines. Without its line breaks and indents, the text is unchanged.
TEST(TextLayout, indents_further_lines) {
  std::string text = "    ";
  for (int i = 0; i < 60; ++i) text += std::to_string(i * i * i) + (i < 59 ? " " : "");
  std::istringstream lines(wrapped(text));
  std::string joined;
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(line.size(), 80U);
    EXPECT_TRUE(line.starts_with(joined.empty() ? "    0" : "      ")) << line;
    joined += joined.empty() ? line : " " + line.substr(6);
  }
  EXPECT_EQ(joined, text);
}

TEST(TextLayout, does_not_break_a_word) {
  const std::string path(100, 'p');
  EXPECT_EQ(wrapped("see " + path + " there"), "see\n  " + path + "\n  there\n");
  EXPECT_EQ(wrapped(path), path + "\n");
}

}  // namespace
}  // namespace gearwright
