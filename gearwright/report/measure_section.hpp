// What a workshop measures of the gears, as a section of the page.
#pragma once

#include <string>
#include <vector>

#include "gearwright/catalogue/value.hpp"

namespace gearwright {

/// A column per gear, records of catalogue/measure_quantities.hpp; empty without any.
std::string measure_section(const std::vector<ValueRecord>& measures);

}  // namespace gearwright
