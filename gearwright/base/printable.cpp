#include "gearwright/base/printable.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "gearwright/base/contract.hpp"

namespace gearwright {

namespace {

// The result for a byte that does not start a code point. Its length of one byte distinguishes it
// from a valid U+FFFD, which has three bytes.
constexpr Utf8Point kWrong{0xFFFD, 1};

bool is_wrong(const Utf8Point& point) {
  return point.code == kWrong.code && point.bytes == kWrong.bytes;
}

}  // namespace

std::string printable(const std::string& text, std::size_t most) {
  std::string out;
  std::string_view rest = text;
  while (!rest.empty() && out.size() < most) {
    const Utf8Point point = first_of_utf8(rest);
    const auto [code, bytes] = point;
    const bool control = code < 0x20 || (code >= 0x7F && code < 0xA0);
    for (const char c : rest.substr(0, bytes)) {
      if (control || is_wrong(point)) {
        out += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
      } else {
        out += c;
      }
    }
    rest.remove_prefix(bytes);
  }
  return rest.empty() ? out : out + "...";
}

Utf8Point first_of_utf8(std::string_view text) {
  GW_EXPECTS(!text.empty());
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

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const Utf8Point point = first_of_utf8(text);
    if (is_wrong(point)) return false;
    text.remove_prefix(point.bytes);
  }
  return true;
}

std::size_t character_count(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins_character));
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
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

std::string_view trimmed(std::string_view text, std::string_view of) {
  const std::size_t begin = std::min(text.find_first_not_of(of), text.size());
  return text.substr(begin, text.find_last_not_of(of) + 1 - begin);
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
