// Parts that all pages share: the head, the style, the hint about pictures, and the spec.
//
// Style sheets and scripts are files in report/page/. The build converts each file into a function
// with the name of the file (cmake/gw_embed.cmake).
#pragma once

#include <string>
#include <string_view>

#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// The style sheet of every page. It is light or dark as the user prefers, and always light on
/// paper. The colours are those of Okabe and Ito, which can be distinguished with any colour
/// vision. Colour alone never carries information.
std::string_view page_style();

/// Additional styles for the page of a design search: the wide table, colours of the edges of a
/// region, dots and curves of the charts.
std::string_view search_style();

/// Makes every picture zoomable (zoom_script.js) and unfolds the tables before printing. Without
/// the script the pictures are static and complete.
std::string_view page_script();

/// The page from the doctype to </head>, including the style. `title` and `version` are plain text.
/// `more_style` is added to the style of the page.
std::string page_head(std::string_view title, std::string_view version,
                      std::string_view more_style = "");

/// The scripts that all pages need and the script of this page, up to the end of the page.
std::string page_end(std::string_view own_script);

/// The hint about zooming. It is hidden until the script of the page makes it visible.
std::string picture_hint();

/// A folded section with the verbatim text of the spec; empty if the text is empty.
std::string spec_section(const std::string& spec);

/// The sections of a page, preceded by a list of links to their headings. Short pages have no list.
std::string with_contents(const std::string& sections);

// The control that turns the gears of a picture (figure/mesh.hpp), and its script.
//
//   t    rotation of gear 1 from the drawn position, in pitches, from 0 to 1. After one pitch, the
//        next tooth takes the place of the first, and the picture repeats.
//
// Without the script, and on paper, the picture is static at t = 0.

/// A button and a slider (HTML) for all pictures in the same group of figures. They are hidden
/// until the script makes them visible.
std::string turn_control(const InvolutePair& pair);

/// The script of this control, report/page/turn_script.js.
std::string_view turn_script();

}  // namespace gearwright
