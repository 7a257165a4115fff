// Parts that all pages share: the head, the style, the hint about pictures, and the spec.
//
// Style sheets and scripts are files of report/page/. The build turns each into the function of its
// name (cmake/gw_embed.cmake). The scripts of turning.hpp and search_table.hpp are embedded in the
// same way.
#pragma once

#include <string>
#include <string_view>

namespace gearwright {

/// Light or dark by the user's preference, and always light on paper. The colours are those of
/// Okabe and Ito, which can be distinguished with any colour vision. No information is in colour
/// alone.
std::string_view page_style();

/// Additional styles for the page of a design search: the wide table, colours of the edges of a
/// region, dots and curves of its charts. Their colours follow those of the page for light, dark
/// and paper.
std::string_view search_style();

/// Makes every picture zoomable (zoom_script.js) and unfolds the tables before printing. Without
/// the script the pictures are static and complete.
std::string_view page_script();

/// The page from the doctype to </head>, style included; title and version are plain text.
/// `more_style` is added to the style of the page.
std::string page_head(std::string_view title, std::string_view version,
                      std::string_view more_style = "");

/// The scripts that all pages need and the page's own one, to the end of the page.
std::string page_end(std::string_view own_script);

/// The hint for zooming. The script of the page makes it visible, so it is hidden without scripts.
std::string picture_hint();

/// A folded section with the verbatim text of the spec; empty if there is no spec.
std::string spec_section(const std::string& spec);

/// The sections of a page, preceded by a list of their headings, each a link. Short pages have no
/// list.
std::string with_contents(const std::string& sections);

}  // namespace gearwright
