// What a workshop measures of the gears, as a section of the page.
#pragma once

#include <string>
#include <vector>

#include "gearwright/catalogue/value.hpp"
#include "gearwright/report/k_diagram.hpp"

namespace gearwright {

/// A column per gear, records of catalogue/measure_quantities.hpp; of gears with tolerances their two
/// ends; the designs of flanks that have one. Empty without any.
std::string measure_section(const std::vector<ValueRecord>& measures,
                            const std::vector<std::vector<ValueRecord>>& ends,
                            const std::vector<KDiagram>& diagrams);

}  // namespace gearwright
