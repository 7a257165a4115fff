// Face widths of a crossed pair: what the lines of action ask for over the pressure angle of the
// common rack, and which part of each face they use where the pair is mounted.
//
//   f, f′  face widths of one flank, and of both flanks about the common perpendicular, mm
//   s_i    axial place on gear i, from the middle of its face, mm
#pragma once

#include <string>

#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// f and f′ over α_wn, with the actual face widths.
///
/// Domain    crossed axes (contract)
std::string face_width_figure(const InvolutePair& pair);

/// The faces from end to end, with what the leading and the trailing line use of them.
///
/// Domain    crossed axes, the flanks meet (contract)
std::string face_use_figure(const InvolutePair& pair);

}  // namespace gearwright
