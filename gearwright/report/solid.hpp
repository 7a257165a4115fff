// The bodies in space, on the page itself: the bytes of a GLB file, and a small viewer for them.
#pragma once

#include <string>
#include <string_view>

#include "gearwright/report/report.hpp"

namespace gearwright {

/// The figure alone; empty without a solid. With a pair the gears turn, gear 1 clockwise seen
/// from +z. Without WebGL one sentence stands in its place.
std::string solid_figure(const ReportInput& input);

/// The same under its own heading.
std::string solid_section(const ReportInput& input);

/// RFC 4648, with padding.
std::string base64(std::string_view bytes);

/// The script's part for it: report/page/solid_script.js.
std::string_view solid_script();

}  // namespace gearwright
