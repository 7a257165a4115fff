// Prepares foreign text, such as titles and file names, for sentences and terminals. The file also
// declares functions that divide and join texts.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace gearwright {

constexpr std::size_t kLongText =
    400;  ///< longest part of a title or a file name that is shown, in bytes

/// Escapes control characters (including the control characters of ISO 6429 above 0x7F) and
/// invalid UTF-8, so that a terminal shows them instead of executing them. The result is cut
/// after the character with which it reaches `most` bytes, and "..." is appended.
std::string printable(const std::string& text, std::size_t most = kLongText);

// Reads UTF-8 one code point at a time, for writers of files with other encodings.

struct Utf8Point {
  char32_t code;
  std::size_t bytes;
};

/// The first code point of a text that is not empty. If the first byte does not start a code point,
/// the result is U+FFFD with one byte.
Utf8Point first_of_utf8(std::string_view text);

std::u32string code_points(std::string_view utf8);

/// True if every code point of the text is complete and valid.
bool is_utf8(std::string_view text);

/// True for the first byte of each code point of a text in UTF-8.
constexpr bool begins_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }
/// The number of code points of a text in UTF-8.
std::size_t character_count(std::string_view text);

/// The text with the letters A to Z in lower case, in every locale.
std::string lower_case(std::string_view text);

/// The parts of a text between the separators. A text without a separator is one part.
std::vector<std::string_view> split(std::string_view text, char separator);

/// The text without these characters at its begin and at its end.
std::string_view trimmed(std::string_view text, std::string_view of = " \t\r\n");

/// "a", "a and b", "a, b and c".
std::string enumerated(const std::vector<std::string>& words);

}  // namespace gearwright
