// Pictures of teeth that touch about points under load: the ellipses of a tooth on its way through the
// mesh, on both flanks, and how hard it presses meanwhile.
#pragma once

#include <string>

#include "gearwright/report/load_report.hpp"

namespace gearwright {

/// Figures (HTML).
///
/// Domain    teeth that touch at points, at least one position in contact (contract)
std::string ellipse_figures(const LoadReport& report);

}  // namespace gearwright
