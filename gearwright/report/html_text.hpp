// Writes links, pictures in columns, and tables of values as HTML. Symbols in HTML are written by
// figure/markup.hpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gearwright/figure/markup.hpp"

namespace gearwright {

constexpr int kLengthDigits = 4;  ///< mm: 0.1 µm, the last digit on a gear drawing
constexpr int kAngleDigits = 5;   ///< degrees: 0.17 µm on a radius of 1 m
constexpr int kRatioDigits = 4;   ///< pure numbers

/// Returns a relative link to the file `name`. All characters except letters, digits, - . _ ~ and /
/// are percent-encoded.
std::string file_link(std::string_view name);

/// Returns the figures in columns, or an empty text if there are none.
std::string side_by_side(std::string_view figures);

/// Returns the legend of the colours of gear 1 and gear 2.
std::string caption_of_gears();

std::string in_columns(std::string_view left, std::string_view right);

/// Returns a table of values under column headings. The first text of each row is the row heading.
/// All texts are HTML, and `style` is the CSS class of the table.
std::string value_table(std::string_view caption, const std::vector<std::string>& heads,
                        const std::vector<std::vector<std::string>>& rows,
                        std::string_view style = "");

}  // namespace gearwright
