// The control that turns the gears of a picture (figure/mesh.hpp), and its script.
//
//   t    rotation of gear 1 from the drawn position, in pitches, 0 … 1. After a pitch, the next
//        tooth is in the position of the first one, and the picture repeats.
//
// Without the script, and on paper, the picture is static at t = 0.
#pragma once

#include <string>
#include <string_view>

#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// Button and slider (HTML) for the pictures in the same group of figures. The script makes them
/// visible.
std::string turn_control(const InvolutePair& pair);

/// The part of the script for this control: report/page/turn_script.js.
std::string_view turn_script();

}  // namespace gearwright
