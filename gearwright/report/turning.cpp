#include "gearwright/report/turning.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "gearwright/base/contract.hpp"
#include "gearwright/report/html_text.hpp"

namespace gearwright {

namespace {

constexpr int kSteps = 120;  // of the slider, and of an arrow key, per pitch

}  // namespace

double turn_per_pitch(const InvolutePair& pair, std::size_t i) {
  GW_EXPECTS(!pair.crossed() && i < 2);
  const double one = 360.0 / std::abs(pair.gears[i].spec.teeth);
  return i == 0 ? one : -pair.side() * one;
}

std::string turn_attribute(const InvolutePair& pair, std::size_t i) {
  return fmt::format("data-turn=\"{:.12g}\"", turn_per_pitch(pair, i));
}

void draw_touches(Svg& svg, const Viewport& view, const InvolutePair& pair) {
  const Mesh<double>& mesh = pair.mesh;
  if (!pair.flanks_meet() || !(mesh.true_ratio > 0.0)) return;
  const auto at = [&](double rho1) {
    const Point<Housing> p = pair.on_line_of_action(rho1);
    return view.px({p.r.x(), p.r.y()});
  };
  const Vec2 C = at(mesh.rho1_C);
  const Vec2 step = at(mesh.rho1_C + mesh.step) - C;
  const double from = (mesh.rho1_true_begin - mesh.rho1_C) / mesh.step;
  const double to = (mesh.rho1_true_end - mesh.rho1_C) / mesh.step;
  // Tooth k touches at C + (t + k) pitches.
  for (int k = static_cast<int>(std::floor(from)); k <= static_cast<int>(std::floor(to)); ++k) {
    svg.begin_group(
        fmt::format("visibility=\"hidden\" data-tooth=\"{}\" data-from=\"{:.6f}\" "
                    "data-to=\"{:.6f}\" data-dx=\"{}\" data-dy=\"{}\"",
                    k, from, to, pixel(step.x()), pixel(step.y())));
    svg.dot(C, 5.0, "touch");
    svg.end_group();
  }
}

std::string turn_control(const InvolutePair& pair) {
  return fmt::format(
      "<div class=\"turn\" data-pitch=\"{:.12g}\" hidden><button type=\"button\">Turn</button> "
      "<label>Gear 1 <input type=\"range\" min=\"0\" max=\"1\" step=\"{:.9g}\" "
      "value=\"0\"></label> <output>0.00°</output></div>\n",
      turn_per_pitch(pair, 0), 1.0 / kSteps);
}

}  // namespace gearwright
