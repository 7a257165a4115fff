#include "gearwright/report/speed_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "gearwright/base/contract.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/plot_axis.hpp"
#include "gearwright/report/svg.hpp"

namespace gearwright {

namespace {

constexpr double kWidth = 640.0;
constexpr double kLeft = 58.0;
constexpr double kRight = 18.0;
constexpr double kTop = 54.0;
constexpr double kPlot = 210.0;
constexpr double kHeight = kTop + kPlot + 50.0;
constexpr int kSteps = 96;

// Flank 1 over flank 2, mm per radian of gear 1.
struct Sliding {
  double across, along;
  double whole() const { return std::hypot(across, along); }
};

Sliding sliding_of(const FlankSpeeds<double>& w) {
  return {w.across[0] - w.across[1], w.along[0] - w.along[1]};
}

Sliding sliding_at(const InvolutePair& pair, double rho1) {
  return sliding_of(flank_speeds(pair.input, pair.mesh, rho1));
}

// mm from C along the line of action.
double along_line(const InvolutePair& pair, double rho1) {
  return (rho1 - pair.mesh.rho1_C) / std::cos(pair.input.gears[0].helix_angle);
}

std::string speed_svg(const InvolutePair& pair) {
  const Mesh<double>& m = pair.mesh;
  const auto rho1 = [&](int k) { return m.rho1_A + k * m.path_length / kSteps; };
  std::array<std::vector<Vec2>, 3> curves;
  double lo = 0.0;
  double hi = 0.0;
  for (int k = 0; k <= kSteps; ++k) {
    const Sliding s = sliding_at(pair, rho1(k));
    const double at = along_line(pair, rho1(k));
    const std::array<double, 3> values{s.across, s.along, s.whole()};
    for (std::size_t i = 0; i < 3; ++i) {
      curves[i].push_back({at, values[i]});
      lo = std::min(lo, values[i]);
      hi = std::max(hi, values[i]);
    }
  }
  const Axis x{along_line(pair, m.rho1_A), along_line(pair, m.rho1_E), kLeft, kWidth - kRight};
  const auto ends = widened(lo, hi, 0.08);
  const Axis y{ends[0], ends[1], kTop + kPlot, kTop};
  Svg svg("speeds", kWidth, kHeight, "Sliding of the flanks",
          "Sliding speeds across and along the teeth and altogether, over the line of action from "
          "A to E.");
  draw_rows(svg, x, y, 5);
  draw_foot(svg, x, kTop, kTop + kPlot, 8,
            "distance from the pitch point C along the line of action, mm");
  svg.text({x.from, kTop - 37}, "sliding, mm per radian of gear 1", Anchor::start, "panel");
  struct Mark {
    const char* letter;
    double rho1;
  };
  std::vector<Mark> marks{
      {"A", m.rho1_A}, {"B", m.rho1_B}, {"C", m.rho1_C}, {"D", m.rho1_D}, {"E", m.rho1_E}};
  std::erase_if(marks, [&](const Mark& k) { return k.rho1 < m.rho1_A || k.rho1 > m.rho1_E; });
  std::vector<double> wanted;
  for (const Mark& k : marks) wanted.push_back(x(along_line(pair, k.rho1)));
  const std::vector<double> placed = spread(wanted, 16.0, kLeft, kWidth - 10.0);
  for (std::size_t i = 0; i < marks.size(); ++i) {
    svg.polyline({{placed[i], kTop - 8}, {wanted[i], kTop - 2}, {wanted[i], kTop + kPlot}},
                 "leader");
    svg.text({placed[i], kTop - 12}, marks[i].letter, Anchor::middle, "letter");
  }
  draw_curve(svg, x, y, curves[2], "curve ink");
  draw_curve(svg, x, y, curves[0], "curve action-curve");
  draw_curve(svg, x, y, curves[1], "curve trailing-curve dash");
  return svg.str();
}

std::string speed_table(const InvolutePair& pair) {
  const Mesh<double>& m = pair.mesh;
  std::string text =
      "<div class=\"scroll\"><table>\n<caption>Speeds of the contact over the flanks, mm per "
      "radian of gear 1</caption>\n<thead><tr><th scope=\"col\">Point</th>";
  for (const char* head : {"across 1", "across 2", "along 1", "along 2", "sliding"}) {
    text += fmt::format("<th scope=\"col\" class=\"value\">{}</th>", head);
  }
  text += "</tr></thead>\n<tbody>\n";
  struct Mark {
    const char* letter;
    double rho1;
  };
  for (const Mark& mark : {Mark{"A", m.rho1_A}, Mark{"C", m.rho1_C}, Mark{"E", m.rho1_E}}) {
    const FlankSpeeds<double> w = flank_speeds(pair.input, m, mark.rho1);
    text += fmt::format("<tr><th scope=\"row\"><strong>{}</strong></th>", mark.letter);
    for (const double v :
         {w.across[0], w.across[1], w.along[0], w.along[1], sliding_of(w).whole()}) {
      text += fmt::format("<td class=\"value\">{}</td>", fixed(v, kRatioDigits));
    }
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

}  // namespace

std::string speed_figures(const InvolutePair& pair) {
  GW_EXPECTS(pair.crossed() && pair.flanks_meet());
  return fmt::format(
      "<figure>{}<figcaption><strong>Sliding of the flanks</strong>, gear 1 over gear 2. <span "
      "class=\"key\"><i class=\"swatch action\"></i>across the teeth</span> <span "
      "class=\"key\"><i class=\"swatch trailing\"></i>along the teeth (dashed)</span> <span "
      "class=\"key\"><i class=\"swatch ink\"></i>altogether</span></figcaption></figure>\n{}",
      speed_svg(pair), speed_table(pair));
}

}  // namespace gearwright
