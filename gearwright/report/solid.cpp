#include "gearwright/report/solid.hpp"

#include <fmt/format.h>

#include <cmath>

namespace gearwright {

namespace {

// The rotation of gear 2 about its own axis when gear 1 turns clockwise by one.
double turn_of_gear_2(const Pair& pair) {
  return static_cast<double>(pair.gear(1).spec.teeth) / pair.gear(2).spec.teeth;
}

}  // namespace

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  constexpr unsigned kMask = 63;
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
    unsigned word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = word << 8 | (k < n ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= n ? kDigits[word >> (18 - 6 * k) & kMask] : '=';
  }
  return text;
}

std::string solid_figure(const ReportInput& input) {
  if (input.solid.empty()) return {};
  const std::string data = base64(input.solid);
  const bool turns = input.pair.has_value();
  const double pitch = 360.0 / std::abs(input.gears[0]->spec.teeth);
  std::string text = fmt::format(
      "<figure class=\"solid\" id=\"solid\" data-turns=\"-1 {:.17g}\" data-pitch=\"{:.12g}\" "
      "data-glb=\"{}\">\n<canvas tabindex=\"0\" role=\"img\" "
      "aria-label=\"The {} in space; arrow keys turn the view, plus and minus come closer and go "
      "back, 0 restores\"></canvas>\n<p class=\"no-solid\" hidden>This browser shows no solids "
      "(WebGL is missing or switched off); the GLB file beside this page opens in any "
      "viewer.</p>\n",
      turns ? turn_of_gear_2(*input.pair) : 0.0, pitch, data, turns ? "pair" : "gear");
  if (turns) {
    text +=
        "<div class=\"turn solid-turn\" hidden><button type=\"button\">Turn</button> "
        "<label>Rotation of gear 1 <input type=\"range\" min=\"0\" max=\"1\" step=\"0.0025\" "
        "value=\"0\"></label> <output>0.00°</output></div>\n";
  }
  return text + fmt::format(
                    "<figcaption><span class=\"on-screen\">Drag turns the "
                    "view; once clicked, the wheel comes closer; double click restores. </span>The "
                    "mesh is within {:.2g} mm of the exact surfaces<span class=\"on-screen\"> and "
                    "takes {:.0f} kB of this page</span>.</figcaption>\n</figure>\n",
                    input.solid_tolerance, static_cast<double>(data.size()) / 1000.0);
}

std::string solid_section(const ReportInput& input) {
  const std::string figure = solid_figure(input);
  if (figure.empty()) return {};
  return "<section><h2>In space</h2>\n" + figure + "</section>\n";
}

}  // namespace gearwright
