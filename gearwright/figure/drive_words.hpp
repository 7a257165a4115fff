// Writes the words at the inputs, the output and the fixed bodies of a drive in its scheme.
// Internal to figure/.
#pragma once

#include <string>
#include <vector>

#include "gearwright/drive/drive.hpp"

namespace gearwright {

/// Returns the name of a body and its part in the drive ("in", "out" or "held"), followed by its
/// speed and its torque. A held body has no speed. For a rack, its speed in m/s (or in pitches per
/// turn of the input, if the speed is unknown) and its force follow. Each line is one text of SVG
/// markup.
std::vector<std::string> end_words(const Drive& drive, std::size_t body);

}  // namespace gearwright
