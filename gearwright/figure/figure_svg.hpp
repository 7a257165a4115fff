// A figure as SVG: one layout with one set of margins, tick rules and number formats for all of them.
//
// The plot takes what the axes' numbers, the key and the words beside it leave of the width; the
// number of ticks follows from the room. Numbers and letters keep their size at every width.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "gearwright/figure/figure.hpp"

namespace gearwright {

inline constexpr double kFigureWidth = 560.0;  ///< px, of a figure in a column of the report

/// The picture. Its group of class "plot" carries `data-x` and `data-y`, "lo hi from to": values and
/// their px, by which figure_script.js reads values and puts a line at a chosen place.
///
/// Domain    width ≥ 240 px; finite axes of some length (contract)
std::string figure_svg(const Figure& figure, double width = kFigureWidth);

/// The picture with its caption, an HTML figure; `attributes` of the whole.
std::string figure_html(const Figure& figure, double width = kFigureWidth,
                        std::string_view attributes = "", std::string_view control = "");

/// The same of a figure that may not be; empty without one.
std::string html_of(const std::optional<Figure>& figure);

/// What the classes of marks look like, what a pointer on a figure reads, and how a picture is zoomed
/// and moved: figure_style.css, figure_script.js and zoom_script.js. The page takes the same files.
std::string_view figure_style();
std::string_view figure_script();
std::string_view zoom_script();

}  // namespace gearwright
