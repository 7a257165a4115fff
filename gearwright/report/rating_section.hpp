// The part of the page about strength: inputs, factors, stresses, safeties, each with its place in
// the standard, as licences print them.
#pragma once

#include <string>

#include "gearwright/catalogue/rating_quantities.hpp"

namespace gearwright {

/// HTML, a section.
std::string rating_section(const RatingView& view);

}  // namespace gearwright
