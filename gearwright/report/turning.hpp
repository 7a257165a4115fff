// The control that turns the gears of a picture (figure/mesh.hpp), and its script.
//
//   t    how far gear 1 has turned out of the drawn position, in its pitches, 0 … 1: a pitch later
//        the next tooth stands where the first one stood, and the picture begins anew
//
// Without the script, and on paper, the picture stands still at t = 0.
#pragma once

#include <string>
#include <string_view>

#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// Button and slider (HTML), for the pictures in the same group of figures; the script shows it.
std::string turn_control(const InvolutePair& pair);

/// The script's part for it: report/page/turn_script.js.
std::string_view turn_script();

}  // namespace gearwright
