// How the flanks of a crossed pair slide over each other: across the teeth, as on parallel axes,
// and along them, as a screw.
#pragma once

#include <string>

#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// A figure and a table: speeds of the contact over the flanks, mm per radian of gear 1.
///
/// Domain    crossed axes, the flanks meet (contract)
std::string speed_figures(const InvolutePair& pair);

}  // namespace gearwright
