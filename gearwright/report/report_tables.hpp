// The tables of the pair: its numbers, its path, what gets in the way. Digits: html_text.hpp.
#pragma once

#include <string>

#include "gearwright/catalogue/pair_quantities.hpp"

namespace gearwright {

/// The catalogue's quantities of a pair, under their headings.
std::string pair_table(const Pair& pair);

/// A … E: distance from the pitch point, radii of curvature, sliding.
std::string path_table(const InvolutePair& pair);

/// Interference by name and amount, or the sentence that none was found.
std::string interference_table(const InvolutePair& pair);

}  // namespace gearwright
