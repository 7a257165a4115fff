// Parts common to all pages: the head, the style, the hint about pictures, and the spec.
//
// Style sheets and scripts are files of report/page/; the build turns each into the function of its
// name (cmake/gw_embed.cmake). turning.hpp and search_table.hpp have their scripts in the same way.
#pragma once

#include <string>
#include <string_view>

namespace gearwright {

/// Light and dark by the user's preference, paper always light. The colours are Okabe and Ito's
/// set, which can be distinguished with any colour vision, and no information is in colour alone.
std::string_view page_style();

/// Additional styles for the page of a design search: the wide table, colours of the edges of a
/// region, dots and curves of its charts. The colours are those of the page, which turn with light,
/// dark and paper.
std::string_view search_style();

/// Makes every picture zoomable (zoom_script.js), unfolds the tables before printing. Without the
/// script the pictures are static and complete.
std::string_view page_script();

/// The page from the doctype to </head>, style included; title and version are plain text.
/// `more_style` is added to the style of the page.
std::string page_head(std::string_view title, std::string_view version,
                      std::string_view more_style = "");

/// The hint for zooming, which the page's script shows where it runs.
std::string picture_hint();

/// A folded section with the verbatim text of the spec; empty if there is no spec.
std::string spec_section(const std::string& spec);

/// The sections of a page with a list of their headings before them, each a link; short pages have
/// none.
std::string with_contents(const std::string& sections);

}  // namespace gearwright
