// Writes words and numbers as HTML and SVG: escaped text, numbers with fixed decimals, symbols with
// indices, captions with their keys.
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

/// The text with & < > " ' replaced by references. Control characters except line feed and tab
/// become U+FFFD.
std::string escaped(std::string_view text);

/// The text with a true minus sign in front of each negative number. Tags and hyphens of words are
/// unchanged.
std::string with_minus(std::string_view markup);

/// The value with a fixed number of decimals, never "-0.000". Returns kNoValue if the value is
/// absent or not finite.
std::string fixed(const std::optional<double>& value, int decimals);
/// The number with its digits in groups of three, "2 754".
std::string counted(std::int64_t n);
std::string percent(double share);  ///< magnitude in percent, without decimals and without "%"

bool is_letter_or_digit(char c);

/// A piece of a symbol such as "d_Ff", "h_aP*" or "C_βI = C_βII".
struct SymbolPiece {
  enum class Place { base, below, above };
  std::string text;
  Place place;
};

/// A subscript extends from '_' over letters, digits and UTF-8 bytes. '*' is a superscript.
std::vector<SymbolPiece> symbol_pieces(std::string_view symbol);

/// "d_Ff" as <var>d</var><sub>Ff</sub>. The symbol is not escaped.
std::string symbol_html(std::string_view symbol);
/// The symbol as tspan elements for an SVG text.
std::string symbol_svg(std::string_view symbol);
/// Any text, escaped, with its symbols formatted: "roll angle at d_Ff". Keys such as face_width_mm
/// are unchanged, because the "_" of a symbol follows a single letter.
std::string with_symbols(std::string_view text);

std::string without_tags(std::string_view markup);

/// The HTML element `figure` with these attributes. It contains the picture and the caption.
std::string captioned(std::string_view picture, std::string_view caption,
                      std::string_view attributes = "");

/// An entry of the key in a caption: a swatch of class `swatch`, followed by the words.
std::string caption_key(std::string_view swatch, std::string_view words);

}  // namespace gearwright
