#include "gearwright/base/utf8.hpp"

#include <array>

#include "gearwright/base/contract.hpp"

namespace gearwright {

Utf8Point first_of_utf8(std::string_view text) {
  GW_EXPECTS(!text.empty());
  constexpr Utf8Point kWrong{0xFFFD, 1};
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return {first, 1};
  const std::size_t bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < bytes) return kWrong;
  char32_t code = first & (0x7Fu >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return kWrong;
    code = (code << 6) | (byte(i) & 0x3Fu);
  }
  // The smallest code point for each number of bytes.
  constexpr std::array<char32_t, 5> kSmallest{0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < kSmallest[bytes] || code > 0x10FFFF || surrogate) return kWrong;
  return {code, bytes};
}

std::u32string code_points(std::string_view utf8) {
  std::u32string points;
  while (!utf8.empty()) {
    const auto [code, bytes] = first_of_utf8(utf8);
    points += code;
    utf8.remove_prefix(bytes);
  }
  return points;
}

}  // namespace gearwright
