// Pieces of HTML: links, pictures in columns, tables of values; words and symbols are figure/markup's.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gearwright/figure/markup.hpp"

namespace gearwright {

constexpr int kLengthDigits = 4;  ///< mm: 0.1 µm, the last digit that a gear drawing carries
constexpr int kAngleDigits = 5;   ///< degrees: 0.17 µm on a radius of 1 m
constexpr int kRatioDigits = 4;   ///< pure numbers

/// A relative link to a file of that name: everything but letters, digits, - . _ ~ and / in
/// percent.
std::string file_link(std::string_view name);

/// Figures side by side.
std::string side_by_side(std::string_view figures);

/// The key of gear 1 and gear 2.
std::string caption_of_gears();

/// Two columns.
std::string in_columns(std::string_view left, std::string_view right);

/// A table of values under their headings, each row with its own heading at the left; all HTML.
/// `style` is the table's class.
std::string value_table(std::string_view caption, const std::vector<std::string>& heads,
                        const std::vector<std::vector<std::string>>& rows,
                        std::string_view style = "");

}  // namespace gearwright
