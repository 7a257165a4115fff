// The path of contact as a strip with its zones, specific sliding over it, and the contact ratios.
#pragma once

#include <string>

#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// The two figures.
std::string path_figures(const InvolutePair& pair);

}  // namespace gearwright
