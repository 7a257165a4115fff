#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "gearwright/base/contract.hpp"
#include "gearwright/report/crossed_figures.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/line_marks.hpp"
#include "gearwright/report/plot_axis.hpp"

namespace gearwright {

namespace {

constexpr PlotArea kArea{640, 58, 18, 54, 210, 50};
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
  const Axis x = kArea.across(along_line(pair, m.rho1_A), along_line(pair, m.rho1_E));
  const auto ends = widened(lo, hi, 0.08);
  const Axis y = kArea.up(ends[0], ends[1]);
  Svg svg("speeds", kArea.width, kArea.height(), "Sliding of the flanks",
          "Sliding speeds across and along the teeth and altogether, over the line of action from "
          "A to E.");
  draw_rows(svg, x, y, 5);
  draw_foot(svg, x, kArea.top, kArea.bottom(), 8,
            "distance from the pitch point C along the line of action, mm");
  svg.text({x.from, kArea.top - 37}, "sliding, mm per radian of gear 1", Anchor::start, "panel");
  const std::vector<PathMark> marks = path_marks(m, m.rho1_E);
  std::vector<double> wanted;
  for (const PathMark& k : marks) wanted.push_back(x(along_line(pair, k.rho1)));
  const std::vector<double> placed = spread(wanted, 16.0, kArea.left, kArea.width - 10.0);
  for (std::size_t i = 0; i < marks.size(); ++i) {
    svg.polyline(
        {{placed[i], kArea.top - 8}, {wanted[i], kArea.top - 2}, {wanted[i], kArea.bottom()}},
        "leader");
    svg.text({placed[i], kArea.top - 12}, marks[i].letter, Anchor::middle, "letter");
  }
  draw_curve(svg, x, y, curves[2], "curve ink");
  draw_curve(svg, x, y, curves[0], "curve action-curve");
  draw_curve(svg, x, y, curves[1], "curve trailing-curve dash");
  return svg.str();
}

std::string speed_table(const InvolutePair& pair) {
  const Mesh<double>& m = pair.mesh;
  std::vector<std::vector<std::string>> rows;
  for (const auto& [letter, rho1] :
       {std::pair("A", m.rho1_A), std::pair("C", m.rho1_C), std::pair("E", m.rho1_E)}) {
    const FlankSpeeds<double> w = flank_speeds(pair.input, m, rho1);
    rows.push_back({fmt::format("<strong>{}</strong>", letter)});
    for (const double v : {w.across[0], w.across[1], w.along[0], w.along[1], sliding_of(w).whole()})
      rows.back().push_back(fixed(v, kRatioDigits));
  }
  return value_table("Speeds of the contact over the flanks, mm per radian of gear 1",
                     {"Point", "across 1", "across 2", "along 1", "along 2", "sliding"}, rows);
}

}  // namespace

std::string speed_figures(const InvolutePair& pair) {
  GW_EXPECTS(pair.crossed() && pair.flanks_meet());
  const std::string keys = caption_key("action", "across the teeth") + " " +
                           caption_key("trailing", "along the teeth (dashed)") + " " +
                           caption_key("ink", "altogether");
  return captioned(speed_svg(pair),
                   "<strong>Sliding of the flanks</strong>, gear 1 over gear 2. " + keys) +
         speed_table(pair);
}

}  // namespace gearwright
