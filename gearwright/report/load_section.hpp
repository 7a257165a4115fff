// The part of the page about teeth under load, one paragraph and its pictures for each thing.
#pragma once

#include <array>
#include <string>

#include "gearwright/report/load_report.hpp"

namespace gearwright {

/// HTML, a section. `shapes` are the gears' in the page's definitions (gear_shape.hpp).
///
/// Domain    at least one torque; positions evenly over one pitch, some of which touch (contract)
std::string load_section(const LoadReport& report, const std::array<std::string, 2>& shapes);

}  // namespace gearwright
