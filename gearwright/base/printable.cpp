#include "gearwright/base/printable.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "gearwright/base/contract.hpp"

namespace gearwright {

std::string printable(const std::string& text, std::size_t most) {
  std::string out;
  for (std::size_t i = 0; i < text.size() && out.size() < most; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte < 0x20 || byte == 0x7F) {
      out += fmt::format("\\x{:02x}", byte);
      continue;
    }
    // Takes whole characters only. The first byte of a character gives its length (UTF-8).
    const std::size_t length = byte < 0x80   ? 1
                               : byte < 0xC0 ? 0
                               : byte < 0xE0 ? 2
                               : byte < 0xF0 ? 3
                                             : 4;
    if (length == 0 || i + length > text.size()) {
      out += fmt::format("\\x{:02x}", byte);
      continue;
    }
    bool whole = true;
    for (std::size_t k = 1; k < length; ++k)
      whole = whole && (static_cast<unsigned char>(text[i + k]) & 0xC0) == 0x80;
    // The control characters U+0080 to U+009F are C2 followed by a byte below A0.
    const bool control = byte == 0xC2 && whole && static_cast<unsigned char>(text[i + 1]) < 0xA0;
    if (whole && !control) {
      out += text.substr(i, length);
      i += length - 1;
    } else {
      out += fmt::format("\\x{:02x}", byte);
    }
  }
  return out.size() < most ? out : out + "...";
}

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

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(separator, at), text.size());
    parts.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

std::string enumerated(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " and " : ", ";
    text += words[i];
  }
  return text;
}

}  // namespace gearwright
