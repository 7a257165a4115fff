// A crossed pair over the pressure angle of the common rack: centre distance, shaft angle and
// contact ratio without backlash, with the least centre distance, its approximations and the place
// where the pair is mounted.
#pragma once

#include <string>

#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// The figure. One curve per panel, all over the same α_wn.
///
/// Domain    crossed axes (contract)
std::string range_figure(const InvolutePair& pair);

}  // namespace gearwright
