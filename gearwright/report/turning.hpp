// Data for the page's script that turns the gears of a picture.
//
//   t    rotation of gear 1 from the drawn position, in its pitches, 0 … 1: after a pitch the next
//        tooth is in the place of the first one, and the picture repeats
//
// Without the script, and on paper, the picture is static at t = 0.
#pragma once

#include <string>

#include "gearwright/figure/svg.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// Degrees by which gear `i` (0, 1) turns while gear 1 turns clockwise by one pitch, clockwise
/// positive, as SVG has it.
///
/// Formula   360/z_1, −σ 360/|z_2|   Domain  parallel axes (contract)
double turn_per_pitch(const InvolutePair& pair, std::size_t i);

/// The same as the attribute of a shape that turns.
std::string turn_attribute(const InvolutePair& pair, std::size_t i);

/// Points at which the flanks of internal gears touch in this section, one for each tooth that
/// passes the usable path within a pitch. They appear once the gears have turned.
void draw_touches(Svg& svg, const Viewport& view, const InvolutePair& pair);

/// Button and slider (HTML), for the pictures in the same group of figures; the script shows it.
std::string turn_control(const InvolutePair& pair);

/// Its part of the script: report/page/turn_script.js.
std::string_view turn_script();

}  // namespace gearwright
