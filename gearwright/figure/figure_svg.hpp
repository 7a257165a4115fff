// Writes a figure as SVG. All figures share one layout, one set of margins, and the same rules for
// ticks and number formats.
//
// The plot takes the width that remains beside the numbers of the axes, the key and the words. The
// number of ticks follows from the available room. Numbers and letters keep their size at every
// width.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "gearwright/figure/figure.hpp"

namespace gearwright {

inline constexpr double kFigureWidth = 560.0;  ///< px, of a figure in a column of the report

/// Returns the picture. The group of class "plot" has the attributes `data-x` and `data-y` with
/// four numbers, "lo hi from to", followed by "log" for a logarithmic axis. The first two are the
/// values at both ends of the axis, and the last two are the positions of these ends in px.
/// figure_script.js uses these attributes to convert px to values.
///
/// Domain    width ≥ 240 px; finite axes of nonzero length (contract)
std::string figure_svg(const Figure& figure, double width = kFigureWidth);

/// Returns the HTML element `figure` with these attributes. It contains the picture, then the HTML
/// text `control`, and then the caption.
std::string figure_html(const Figure& figure, double width = kFigureWidth,
                        std::string_view attributes = "", std::string_view control = "");

/// Returns figure_html() of the figure, or nothing if there is no figure.
std::string html_of(const std::optional<Figure>& figure);

/// Return the styles of the marks (figure_style.css), the script that shows values at the pointer
/// (figure_script.js), and the script for zooming (zoom_script.js). The web page uses the same
/// files.
std::string_view figure_style();
std::string_view figure_script();
std::string_view zoom_script();

}  // namespace gearwright
