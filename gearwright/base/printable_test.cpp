// Texts of users in sentences and on terminals.
//
// (1) a text that reaches the limit with its last character is complete; (2) a longer text is cut
// after a whole character; (3) control characters and invalid UTF-8 are escaped, byte by byte;
// (4) a text without them is unchanged.
#include "gearwright/base/printable.hpp"

#include <gtest/gtest.h>

namespace gearwright {
namespace {

TEST(Printable, a_text_is_cut_only_if_it_is_longer_than_the_limit) {
  EXPECT_EQ(printable("twelve bytes", 12), "twelve bytes");  // (1)
  EXPECT_EQ(printable("twelve bytes", 13), "twelve bytes");
  EXPECT_EQ(printable("twelve bytes", 11), "twelve byte...");  // (2)
  EXPECT_EQ(printable("10 µm", 6), "10 µm");
  EXPECT_EQ(printable("10 µ", 4), "10 µ");
  EXPECT_EQ(printable("10 µm", 4), "10 µ...");
  EXPECT_EQ(printable("a\n", 5), "a\\x0a");
  EXPECT_EQ(printable("a\nb", 5), "a\\x0a...");
  EXPECT_EQ(printable("", 0), "");
}

TEST(Printable, escapes_what_is_not_a_character) {
  EXPECT_EQ(printable("\x1b[31m\x7f"), "\\x1b[31m\\x7f");  // (3)
  EXPECT_EQ(printable("\xc2\x85"), "\\xc2\\x85");          // U+0085
  EXPECT_EQ(printable("\x80"), "\\x80");
  EXPECT_EQ(printable("a\xc3"), "a\\xc3");
  EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf");                    // "/" in two bytes
  EXPECT_EQ(printable("\xe0\x82\x9b"), "\\xe0\\x82\\x9b");           // U+009B in three bytes
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");           // a surrogate
  EXPECT_EQ(printable("\xf5\x80\x80\x80"), "\\xf5\\x80\\x80\\x80");  // above U+10FFFF
  EXPECT_EQ(printable("α₁ = 20°, Ã, 歯車, 😀, \uFFFD"), "α₁ = 20°, Ã, 歯車, 😀, \uFFFD");  // (4)
}

}  // namespace
}  // namespace gearwright
