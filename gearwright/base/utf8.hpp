// Reads UTF-8 one code point at a time, for writers of files with other encodings.
#pragma once

#include <cstddef>
#include <string_view>

namespace gearwright {

/// One code point and its number of bytes.
struct Utf8Point {
  char32_t code;
  std::size_t bytes;
};

/// The first code point of a text that is not empty. If the first byte does not start a code point, the result is
/// U+FFFD with one byte.
Utf8Point first_of_utf8(std::string_view text);

std::u32string code_points(std::string_view utf8);

}  // namespace gearwright
