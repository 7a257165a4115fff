#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/report/crossed_figures.hpp"
#include "gearwright/report/crossed_range.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/line_marks.hpp"

namespace gearwright {

namespace {

// Styles of the face widths required by one flank of gears 1 and 2, and by both flanks.
constexpr std::array kWidthStyles{"g1", "g2 fine", "dash g1", "dash g2 fine"};

double degrees_of(double rad) { return Angle::radians(rad).deg(); }

// Returns the upper end of the axis of face widths. The axis contains the required and the actual
// widths. Where the contact ratio is at least 1, the axis also contains the curves, but only up to
// 1.8 times the greatest of these widths. The curves are cut off above this limit, because the
// required face width is unbounded if the lines of action move along the teeth.
double max_shown(const CrossedPair& pair, const std::vector<CrossedSample>& samples) {
  double there = 0.0;
  double curves = 0.0;
  for (int i : {0, 1}) {
    there = std::max({there, pair.input.face_width[i], pair.face_widths.both_flanks[i]});
    for (const CrossedSample& s : samples) {
      if (s.contact_ratio >= 1.0) curves = std::max(curves, s.faces.both_flanks[i]);
    }
  }
  return 1.12 * std::max(there, std::min(curves, 1.8 * there));
}

// Draws the part of the face that a line of action uses. The line is thin from tip to tip, and
// thick where it lies within the usable flanks and within both faces.
void add_use(Figure& f, const CrossedPair& pair, std::size_t i, bool leading, double y) {
  const Mesh<double>& m = pair.mesh;
  const double sign = leading ? 1.0 : -1.0;
  const auto at = [&](double rho1) { return Vec2(sign * axial_place(m, rho1)[i], y); };
  const Vec2 A = at(m.rho1_A), E = at(m.rho1_E);
  const std::string style = leading ? "action" : "trailing";
  f.line({A, E}, style + "-line reached");
  if (m.rho1_true_begin < m.rho1_true_end)
    f.line({at(m.rho1_true_begin), at(m.rho1_true_end)}, style);
  const double side = A.x() <= E.x() ? -12.0 : 12.0;
  f.point(A, 3.0, "mark " + style + "-dot", leading ? "A" : "A′", {side, 0.0});
  f.point(E, 3.0, "mark " + style + "-dot", leading ? "E" : "E′", {-side, 0.0});
}

// Returns a sentence about the parts of the lines of action that lie outside the faces.
std::string beyond(const CrossedPair& pair) {
  std::string text;
  for (const std::size_t i : {0u, 1u}) {
    const double more = (pair.face_widths.both_flanks[i] - pair.input.face_width[i]) / 2;
    if (more > 0.0)
      text +=
          fmt::format(" The lines of gear {} reach {} mm beyond the face.", i + 1, fixed(more, 2));
  }
  return text.empty() ? " Both lines lie within both faces." : text;
}

constexpr int kSpeedSteps = 96;

// Sliding speed of flank 1 over flank 2, mm per radian of gear 1.
struct Sliding {
  double across, along;
  double whole() const { return std::hypot(across, along); }
};

Sliding sliding_of(const FlankSpeeds<double>& w) {
  return {w.across[0] - w.across[1], w.along[0] - w.along[1]};
}

Sliding sliding_at(const CrossedPair& pair, double rho1) {
  return sliding_of(flank_speeds(pair.input, pair.mesh, rho1));
}

// Returns the distance along the line of action from C, mm.
double along_line(const CrossedPair& pair, double rho1) {
  return (rho1 - pair.mesh.rho1_C) / std::cos(pair.input.gears[0].helix_angle);
}

}  // namespace

Figure face_width_figure(const CrossedPair& pair) {
  const std::vector<CrossedSample> samples = crossed_samples(pair);
  Figure f{
      "widths",
      "Face widths",
      "Face widths that one flank and both flanks of each gear require, over the normal pressure "
      "angle of the common rack. Lines show the actual face widths.",
      fmt::format(
          " required by the lines of action, without backlash. Full curves are for one flank ({}). "
          "Dashed curves are for both flanks, measured about the common perpendicular ({}).{}{}",
          symbol_html("f"), symbol_html("f′"),
          pair.flanks_meet() ? " The dots show the pair as mounted." : "",
          pair.contact_ratio_range ? " In the shaded range the contact ratio is at least 1." : ""),
      {},
      {"face width", "mm", 0.0, max_shown(pair, samples)}};
  f.keys = {{"line edge-g1", "gear 1"}, {"line fine edge-g2", "gear 2"}};
  const double most = f.y.hi;
  add_angles(f, pair, samples);
  for (const std::size_t i : {0u, 1u}) {
    const auto one = [&](const CrossedSample& s) { return s.faces.one_flank[i]; };
    const auto both = [&](const CrossedSample& s) { return s.faces.both_flanks[i]; };
    f.line(over_angle(samples, one), std::string("curve ") + kWidthStyles[i],
           fmt::format("gear {}, one flank", i + 1));
    f.line(over_angle(samples, both), std::string("curve ") + kWidthStyles[2 + i],
           fmt::format("gear {}, both flanks", i + 1));
  }
  // Horizontal lines at the actual face widths. Equal face widths share one line and its label.
  const bool equal = pair.input.face_width[0] == pair.input.face_width[1];
  for (const std::size_t i : {0u, 1u}) {
    if (equal && i == 1) break;
    const double width = pair.input.face_width[i];
    const std::string ink = equal ? "" : std::string(" ") + kInk[i];
    f.line({{f.x.hi, width}, {f.x.lo, width}}, "face-line" + ink);
    f.marks.back().label =
        symbol_svg(i == 0 ? "b_1" : "b_2") + (equal ? " = " + symbol_svg("b_2") : "") + " = ";
    f.marks.back().length = {width, 2};
    f.marks.back().label_style = "halo" + ink;
    f.marks.back().border = true;
  }
  for (const std::size_t i : {0u, 1u}) {
    if (!pair.flanks_meet()) break;
    for (const double width : {pair.face_widths.one_flank[i], pair.face_widths.both_flanks[i]}) {
      if (width <= most)
        f.dot({degrees_of(pair.mesh.rack.normal_pressure_angle), width}, 3.2,
              std::string("mark ") + kInk[i],
              fmt::format("gear {}: {} mm", i + 1, fixed(width, 2)));
    }
  }
  return f;
}

Figure face_use_figure(const CrossedPair& pair) {
  GW_EXPECTS(pair.flanks_meet());
  double reach = 0.0;
  for (const std::size_t i : {0u, 1u}) {
    reach = std::max({reach, pair.input.face_width[i] / 2, pair.face_widths.both_flanks[i] / 2});
  }
  Figure f{
      "faces",
      "Use of the faces",
      "The face of each gear from end to end, with the parts that the leading and the trailing "
      "line of action use.",
      fmt::format(" as mounted. {} {} Thick parts lie within the usable flanks and the faces.{}",
                  caption_key("action", "leading flanks A–E"),
                  caption_key("trailing", "trailing flanks A′–E′"), beyond(pair)),
      {"distance along each axis from the common perpendicular", "mm", -1.1 * reach, 1.1 * reach},
      {"", "", 0.0, 2.0}};
  f.tall = 0.32;
  for (const std::size_t i : {0u, 1u}) {
    const double middle = i == 0 ? 1.5 : 0.5, half = pair.input.face_width[i] / 2;
    f.y.names.push_back({middle, fmt::format("gear {}", i + 1)});
    f.bar({-half, middle - 0.36}, {half, middle + 0.36}, std::string("face ") + kInk[i],
          fmt::format("face of gear {}: {} mm", i + 1, fixed(2 * half, 2)));
    add_use(f, pair, i, true, middle + 0.18);
    add_use(f, pair, i, false, middle - 0.18);
  }
  f.line({{0.0, -kInfinity}, {0.0, kInfinity}}, "thin dashdot");
  return f;
}

Figure speed_figure(const CrossedPair& pair) {
  GW_EXPECTS(pair.flanks_meet());
  const Mesh<double>& m = pair.mesh;
  Figure f{"speeds",
           "Sliding of the flanks",
           "Sliding speeds across the teeth, along the teeth and in total, over the line of action "
           "from A to E.",
           " of gear 1 over gear 2, per radian of gear 1.",
           {"distance from the pitch point C along the line of action", "mm"},
           {"sliding", "mm/rad"}};
  std::array<std::vector<Vec2>, 3> curves;
  for (int k = 0; k <= kSpeedSteps; ++k) {
    const double rho1 = m.rho1_A + k * m.path_length / kSpeedSteps;
    const Sliding s = sliding_at(pair, rho1);
    const double at = along_line(pair, rho1);
    curves[0].push_back({at, s.whole()});
    curves[1].push_back({at, s.across});
    curves[2].push_back({at, s.along});
  }
  f.line(std::move(curves[0]), "curve ink", "total");
  f.line(std::move(curves[1]), "curve action-curve", "across the teeth");
  f.line(std::move(curves[2]), "curve trailing-curve dash", "along the teeth");
  f.keys = {{"line edge-eps", "across the teeth"},
            {"line dash edge-c", "along the teeth"},
            {"line edge-mesh", "total"}};
  fit_axes(f, 0.1);
  f.y.lo = std::min(f.y.lo, 0.0);
  std::vector<LetterAt> letters;
  for (const PathMark& k : path_marks(m, m.rho1_E))
    letters.push_back({k.letter, Vec2(along_line(pair, k.rho1), -kInfinity)});
  add_letters(f, letters);
  return f;
}

std::string speed_table(const CrossedPair& pair, UnitSystem units) {
  const Mesh<double>& m = pair.mesh;
  std::vector<std::vector<std::string>> rows;
  for (const auto& [letter, rho1] :
       {std::pair("A", m.rho1_A), std::pair("C", m.rho1_C), std::pair("E", m.rho1_E)}) {
    const FlankSpeeds<double> w = flank_speeds(pair.input, m, rho1);
    rows.push_back({fmt::format("<strong>{}</strong>", letter)});
    for (const double v : {w.across[0], w.across[1], w.along[0], w.along[1], sliding_of(w).whole()})
      rows.back().push_back(text_in(units, Unit::mm_per_rad, v, kRatioDigits));
  }
  return value_table(fmt::format("Speeds of the contact over the flanks per radian of gear 1, {}",
                                 unit_text(units, Unit::mm_per_rad)),
                     {"Point", "across 1", "across 2", "along 1", "along 2", "sliding"}, rows);
}

}  // namespace gearwright
