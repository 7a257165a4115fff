// Writes the words at the inputs, the output and the fixed bodies of a drive in its scheme.
// Internal to figure/.
#pragma once

#include <string>
#include <vector>

#include "gearwright/drive/drive.hpp"

namespace gearwright {

/// Returns the lines of words for a body, each as one text of SVG markup. The first line is the
/// name of the body and its part in the drive ("in", "out" or "held"). The next lines are the speed
/// and the torque or, for a rack, the speed and the force. A held body has no speed. If the speed
/// or the torque of the input is not given, the value is relative to the input.
std::vector<std::string> end_words(const Drive& drive, std::size_t body);

}  // namespace gearwright
