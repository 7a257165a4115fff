// UTF-8, one code point after the other: what files with an alphabet of their own are written from.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace gearwright {

/// One code point and how many bytes it took.
struct Utf8Point {
  char32_t code;
  std::size_t bytes;
};

/// The first code point of a text that is not empty; U+FFFD, one byte, for a byte that begins none.
Utf8Point first_of_utf8(std::string_view text);

std::u32string code_points(std::string_view utf8);

}  // namespace gearwright
