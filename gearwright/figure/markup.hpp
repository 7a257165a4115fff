// Writes words and numbers as HTML and SVG. The functions escape text, and format numbers with
// fixed decimals, symbols with indices, and captions with their keys.
//
// Symbols are written as in the comments, "d_Ff", "h_aP*", "k m_n", and shown with subscripts.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gearwright {

/// The sign for a missing value.
constexpr std::string_view kNoValue = "–";

/// Returns the text with & < > " ' replaced by references. Carriage returns are removed. Other
/// control characters except line feed and tab become U+FFFD.
std::string escaped(std::string_view text);

/// Returns the text with a true minus sign in front of each negative number. Tags and hyphens of
/// words are unchanged.
std::string with_minus(std::string_view markup);

/// Formats the value with a fixed number of decimals, never as "-0.000". Returns kNoValue if the
/// value is absent or not finite.
std::string fixed(const std::optional<double>& value, int decimals);
/// Returns the number with its digits in groups of three, "2 754".
std::string counted(std::int64_t n);
std::string percent(double share);  ///< magnitude in percent, without decimals and without "%"

bool is_letter_or_digit(char c);

/// A piece of a symbol such as "d_Ff", "h_aP*" or "C_βI = C_βII".
struct SymbolPiece {
  enum class Place { base, below, above };
  std::string text;
  Place place;
};

/// Divides a symbol into pieces. A subscript extends from '_' over letters, digits, UTF-8 bytes and
/// commas without a following space. The sign '*' is a superscript.
std::vector<SymbolPiece> symbol_pieces(std::string_view symbol);

/// Returns, for example, <var>d</var><sub>Ff</sub> for "d_Ff". The symbol is not escaped.
std::string symbol_html(std::string_view symbol);
/// Returns the symbol as tspan elements for an SVG text.
std::string symbol_svg(std::string_view symbol);
/// Returns the text, escaped, with its symbols formatted, for example "roll angle at d_Ff". Keys
/// such as face_width_mm are unchanged, because the "_" of a symbol follows a single letter.
std::string with_symbols(std::string_view text);

std::string without_tags(std::string_view markup);

/// Returns the HTML element `figure` with these attributes, the picture and the caption.
std::string captioned(std::string_view picture, std::string_view caption,
                      std::string_view attributes = "");

/// Returns an entry of the key in a caption. It consists of a swatch of class `swatch`, followed by
/// the words.
std::string caption_key(std::string_view swatch, std::string_view words);

}  // namespace gearwright
