// The most important numbers of a pair, at the head of the report.
#pragma once

#include <string>

#include "gearwright/report/report.hpp"

namespace gearwright {

/// A box for each available key figure: ratio, centre distance, contact ratio, backlash (at
/// both ends of tolerances), safeties, pressure, unevenness. Rows of the catalogue with their words,
/// symbols and units; empty without any.
std::string key_figures(const ReportInput& input);

}  // namespace gearwright
