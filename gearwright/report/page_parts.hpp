// What every page has: its head, the hint about pictures, the spec it was made from.
#pragma once

#include <string>
#include <string_view>

namespace gearwright {

/// From the doctype to </head>, style included; title and version are plain text. `more_style` is
/// added to the page's.
std::string page_head(std::string_view title, std::string_view version,
                      std::string_view more_style = "");

/// How to zoom; shown by the page's script where it runs.
std::string picture_hint();

/// The spec, verbatim, folded; empty without one.
std::string spec_section(const std::string& spec);

/// The sections of a page with a list of their headings before them, each a link; short pages have
/// none.
std::string with_contents(const std::string& sections);

}  // namespace gearwright
