// What a workshop measures of the gears, as a section of the page.
#pragma once

#include <string>
#include <vector>

#include "gearwright/catalogue/value.hpp"
#include "gearwright/report/k_diagram.hpp"

namespace gearwright {

/// A column per gear, records of catalogue/measure_quantities.hpp, and the designs of flanks that have
/// one; empty without any.
std::string measure_section(const std::vector<ValueRecord>& measures,
                            const std::vector<KDiagram>& diagrams);

}  // namespace gearwright
