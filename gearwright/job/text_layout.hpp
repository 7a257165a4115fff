// Text in columns and in lines of a limited width, for terminals. Internal to job.
//
// The width of a text is its number of characters, because a terminal shows each character of the
// listings in one column.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace gearwright {

constexpr std::size_t kLineWidth = 80;    ///< width of sentences, the usual width of a terminal
constexpr std::size_t kTableWidth = 110;  ///< width of tables with a row for each design

/// Number of characters of UTF-8 text.
std::size_t text_width(std::string_view text);
/// The text with blanks after it, up to `width` characters.
std::string padded(const std::string& text, std::size_t width);
/// The text with blanks before it, up to `width` characters.
std::string padded_left(const std::string& text, std::size_t width);

/// Sentences broken at blanks into lines of at most kLineWidth characters, if no word is longer.
/// Blanks at the start are kept, the lines after the first begin with two more blanks, and every
/// line ends with a line break.
std::string wrapped(std::string_view text);

}  // namespace gearwright
