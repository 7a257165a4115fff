// The control that turns the gears of a picture (figure/mesh.hpp), and its script.
//
//   t    rotation of gear 1 from the drawn position, in pitches, from 0 to 1. After one pitch, the
//        next tooth takes the place of the first, and the picture repeats.
//
// Without the script, and on paper, the picture is static at t = 0.
#pragma once

#include <string>
#include <string_view>

#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// A button and a slider (HTML) for all pictures in the same group of figures. They are hidden
/// until the script makes them visible.
std::string turn_control(const InvolutePair& pair);

/// The script of this control, report/page/turn_script.js.
std::string_view turn_script();

}  // namespace gearwright
