#include "gearwright/report/turning.hpp"

#include <fmt/format.h>

#include "gearwright/figure/mesh.hpp"

namespace gearwright {

namespace {

constexpr int kSteps = 120;  // steps per pitch, of the slider and of the arrow keys

}  // namespace

std::string turn_control(const InvolutePair& pair) {
  return fmt::format(
      "<div class=\"turn\" data-pitch=\"{:.12g}\" hidden><button type=\"button\">Turn</button> "
      "<label>Gear 1 <input type=\"range\" min=\"0\" max=\"1\" step=\"{:.9g}\" "
      "value=\"0\"></label> <output>0.00°</output></div>\n",
      turn_per_pitch(pair, 0), 1.0 / kSteps);
}

}  // namespace gearwright
