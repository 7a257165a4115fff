// The path of contact as a strip with its zones, specific sliding over it, and the contact ratios.
#pragma once

#include <string>

#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// The strip with the zones and the specific sliding.
std::string path_figure(const InvolutePair& pair);

/// Transverse, overlap and total contact ratio as bars.
std::string ratio_figure(const InvolutePair& pair);

}  // namespace gearwright
