// The part of the page about corrections: what a workshop would change, and what it does to each of
// the aims.
#pragma once

#include <string>

#include "gearwright/catalogue/compensate_quantities.hpp"

namespace gearwright {

/// HTML, a section.
///
/// Domain    `before` of a pair that touches somewhere (contract)
std::string compensate_section(const CompensateView& view);

}  // namespace gearwright
