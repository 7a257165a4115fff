// Words and numbers in HTML and SVG: escaped text, numbers with fixed decimals, symbols with
// indices, captions with their keys.
//
// Symbols are written as in the comments, "d_Ff", "h_aP*", "k m_n", and shown with subscripts.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace gearwright {

/// The sign for a missing value.
constexpr std::string_view kNoValue = "–";

/// The text with & < > " ' as references. Control characters except line feed and tab become
/// U+FFFD.
std::string escaped(std::string_view text);

/// Fixed decimals, never "-0.000". Returns kNoValue if there is no value or it is not finite.
std::string fixed(const std::optional<double>& value, int decimals);
/// Groups of three digits, "2 754".
std::string counted(std::int64_t n);
std::string percent(double share);  ///< percentage without decimals and without its sign

/// "d_Ff" as <var>d</var><sub>Ff</sub>. The symbol is trusted and not escaped.
std::string symbol_html(std::string_view symbol);
/// The same as tspans for an SVG text.
std::string symbol_svg(std::string_view symbol);
/// Any text, escaped, with its symbols formatted: "roll angle at d_Ff". Keys such as face_width_mm
/// are unchanged, because the "_" of a symbol follows a single letter.
std::string with_symbols(std::string_view text);

/// Markup without its tags.
std::string without_tags(std::string_view markup);

/// A picture with its controls and the caption below. `attributes` belong to the whole.
std::string captioned(std::string_view picture, std::string_view caption,
                      std::string_view attributes = "");

/// An entry of the key of a caption: a swatch of that class followed by the words.
std::string caption_key(std::string_view swatch, std::string_view words);

}  // namespace gearwright
