// The bodies in space, on the page itself: the bytes of a GLB file, and a small viewer for them.
#pragma once

#include <string>
#include <string_view>

#include "gearwright/report/report.hpp"

namespace gearwright {

/// The figure alone; empty without a solid. With a pair the gears turn, gear 1 clockwise seen from
/// +z. Without WebGL a sentence replaces it.
std::string solid_figure(const ReportInput& input);

/// The same under its own heading.
std::string solid_section(const ReportInput& input);

/// RFC 4648, with padding.
std::string base64(std::string_view bytes);

/// Its part of the script: report/page/solid_script.js.
std::string_view solid_script();

}  // namespace gearwright
