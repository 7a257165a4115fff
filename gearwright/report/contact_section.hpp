// The part of the page about tooth contact: pictures, and words for readers who have never seen
// such an analysis.
#pragma once

#include <string>

#include "gearwright/report/contact_report.hpp"

namespace gearwright {

/// The section of the page.
///
/// Domain    two gears with teeth; results of the same positions over one pitch, one at least with
///           contact; rasters of 2 × 2 or more (contract)
std::string contact_section(const ContactReport& report);

}  // namespace gearwright
