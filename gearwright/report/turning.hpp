// The control that turns the gears of a picture (figure/mesh.hpp), and its script.
//
//   t    rotation of gear 1 from the drawn position, in its pitches, 0 … 1: after a pitch the next
//        tooth is in the place of the first one, and the picture repeats
//
// Without the script, and on paper, the picture is static at t = 0.
#pragma once

#include <string>
#include <string_view>

#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// Button and slider (HTML), for the pictures in the same group of figures; the script shows it.
std::string turn_control(const InvolutePair& pair);

/// Its part of the script: report/page/turn_script.js.
std::string_view turn_script();

}  // namespace gearwright
