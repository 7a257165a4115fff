// Pieces of HTML and SVG: escaped words, numbers with the digits of a drawing, symbols with indices,
// captioned pictures and tables of values.
//
// Symbols are written as in our comments, "d_Ff", "h_aP*", "k m_n", and set with real indices.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gearwright {

constexpr int kLengthDigits = 4;  ///< mm: 0.1 µm, the last digit that a gear drawing carries
constexpr int kAngleDigits = 5;   ///< degrees: 0.17 µm on a radius of 1 m
constexpr int kRatioDigits = 4;   ///< pure numbers

/// A sign for "there is no such value".
constexpr std::string_view kNoValue = "–";

/// The text with & < > " ' as references; control characters but line feed and tab become U+FFFD.
std::string escaped(std::string_view text);

/// A relative link to a file of that name: everything but letters, digits, - . _ ~ and / in
/// percent.
std::string file_link(std::string_view name);

/// Fixed decimals, never "-0.000"; kNoValue where there is none or it is not finite.
std::string fixed(const std::optional<double>& value, int decimals);
std::string percent(double share);  ///< whole percent, without its sign

/// "d_Ff" as <var>d</var><sub>Ff</sub>; the symbol is ours and is not escaped.
std::string symbol_html(std::string_view symbol);
/// The same as tspans for an SVG text.
std::string symbol_svg(std::string_view symbol);
/// Any text, escaped, with the symbols in it set: "roll angle at d_Ff". Keys as face_width_mm stay:
/// a symbol has one letter before its "_".
std::string with_symbols(std::string_view text);

/// A picture with its controls, and its caption below; `attributes` of the whole.
std::string captioned(std::string_view picture, std::string_view caption,
                      std::string_view attributes = "");

/// Figures side by side.
std::string side_by_side(std::string_view figures);

/// What a line or a colour means, of a caption: a swatch of that class before the words.
std::string caption_key(std::string_view swatch, std::string_view words);

/// The keys of gear 1 and gear 2.
std::string caption_of_gears();

/// Two columns.
std::string in_columns(std::string_view left, std::string_view right);

/// A table of values under their heads, each row with a head of its own at its left; all HTML.
/// `style` is the table's class.
std::string value_table(std::string_view caption, const std::vector<std::string>& heads,
                        const std::vector<std::vector<std::string>>& rows,
                        std::string_view style = "");

}  // namespace gearwright
