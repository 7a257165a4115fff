// Stress at the roots of loaded teeth: along the drawn fillet, and over the face.
#pragma once

#include <string>

#include "gearwright/report/load_report.hpp"

namespace gearwright {

/// A figure for each gear and one for the face.
std::string root_stress_figures(const LoadReport& report, const std::array<std::string, 2>& shapes);

}  // namespace gearwright
