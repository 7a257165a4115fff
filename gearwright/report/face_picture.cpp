#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/figure/free_labels.hpp"
#include "gearwright/report/crossed_figures.hpp"
#include "gearwright/report/crossed_range.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/line_marks.hpp"
#include "gearwright/report/plot_axis.hpp"

namespace gearwright {

namespace {

constexpr PlotArea kArea{640, 58, 18, 58, 230, 50};

double deg(double rad) { return Angle::radians(rad).deg(); }

// The range extends at least to the required and the actual width. It includes the curves for ε ≥
// 1, but only up to twice that width, because f′ is unbounded if the lines of action move along the
// teeth.
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

std::string widths_svg(const CrossedPair& pair) {
  const std::vector<CrossedSample> samples = crossed_samples(pair);
  const Axis x = angle_axis(samples, kArea);
  const Axis y = kArea.up(0.0, max_shown(pair, samples));
  Svg svg("widths", kArea.width, kArea.height(),
          "Face widths over the pressure angle of the common rack",
          "Face widths that one flank and both flanks of each gear need, over the normal pressure "
          "angle of the common rack, with the actual face widths as lines.");
  draw_angles(svg, pair, x, kArea);
  draw_rows(svg, x, y, 5);
  svg.text({x.from, kArea.top - 36}, "face widths, mm", Anchor::start, "panel");
  const Vec2 here(x(deg(pair.mesh.rack.normal_pressure_angle)), 0.0);
  FreeLabels labels({x.from, kArea.top, x.to, kArea.bottom()});
  const auto curve = [&](const std::vector<Vec2>& values, const std::string& style) {
    draw_curve(svg, x, y, values, style);
    std::vector<Vec2> px;
    for (const Vec2& v : values) px.push_back({x(v.x()), y(v.y())});
    labels.keep_off(px);
  };
  svg.begin_clip(x.from, kArea.top, x.to - x.from, kArea.tall);
  for (const std::size_t i : {0u, 1u}) {
    const auto one = [&](const CrossedSample& s) { return s.faces.one_flank[i]; };
    const auto both = [&](const CrossedSample& s) { return s.faces.both_flanks[i]; };
    curve(over_angle(samples, one), std::string("curve ") + kInk[i]);
    curve(over_angle(samples, both), std::string("curve dash ") + kInk[i]);
  }
  svg.end_group();
  labels.keep_off({{here.x(), kArea.top}, {here.x(), kArea.bottom()}});
  // The actual faces. Equal faces share a line. Their names are at its right end, or further left
  // if they would touch the curves.
  const bool equal = pair.input.face_width[0] == pair.input.face_width[1];
  for (const std::size_t i : {0u, 1u}) {
    if (equal && i == 1) break;
    const double at = y(pair.input.face_width[i]);
    svg.line({x.from, at}, {x.to, at}, equal ? "face-line" : std::string("face-line ") + kInk[i]);
    const std::string value = " = " + fixed(pair.input.face_width[i], 2);
    const std::string name = i == 0 ? "b_1" : "b_2";
    std::vector<LabelPlace> places;
    for (double right = x.to - 6; right > x.from + 120; right -= 20)
      for (const double off : {-11.0, 13.0})
        places.push_back({{right, at}, {0.0, off}, Anchor::end});
    labels.draw(svg, equal ? "b1 = b2" + value : "b1" + value,
                symbol_svg(equal ? "b_1" : name) + (equal ? " = " + symbol_svg("b_2") : "") + value,
                std::string("halo ") + (equal ? "" : kInk[i]), places, FreeLabels::If::always);
  }
  for (const std::size_t i : {0u, 1u}) {
    if (!pair.flanks_meet()) break;
    for (const double f : {pair.face_widths.one_flank[i], pair.face_widths.both_flanks[i]}) {
      if (f <= y.hi) svg.dot({here.x(), y(f)}, 3.2, std::string("mark ") + kInk[i]);
    }
  }
  return svg.str();
}

constexpr double kStrip = 34.0;  // px, height of a face
constexpr double kRow = 104.0;
constexpr PlotArea kFaces{640, kArea.left + 14, 18, 30, 2 * kRow - 6, 46};

// The part of the face used by a line: the reach of the tips, and within it the part that flanks
// and faces leave.
void draw_use(Svg& svg, const CrossedPair& pair, std::size_t i, bool leading, const Axis& x,
              double y) {
  const Mesh<double>& m = pair.mesh;
  const double sign = leading ? 1.0 : -1.0;
  const auto at = [&](double rho1) { return x(sign * axial_place(m, rho1)[i]); };
  const double A = at(m.rho1_A);
  const double E = at(m.rho1_E);
  const char* style = leading ? "action" : "trailing";
  svg.line({A, y}, {E, y}, std::string(style) + "-line reached");
  if (m.rho1_true_begin < m.rho1_true_end)
    svg.line({at(m.rho1_true_begin), y}, {at(m.rho1_true_end), y}, style);
  const std::string dot = std::string("mark ") + style + "-dot";
  const double side = A <= E ? -1.0 : 1.0;
  const auto label = [&](double px, const char* letter, double to) {
    svg.dot({px, y}, 3.0, dot);
    svg.text({px, y}, letter, to < 0 ? Anchor::end : Anchor::start, "letter halo", {8.0 * to, 5.0});
  };
  label(A, leading ? "A" : "A′", side);
  label(E, leading ? "E" : "E′", -side);
}

std::string faces_svg(const CrossedPair& pair) {
  double reach = 0.0;
  for (const std::size_t i : {0u, 1u}) {
    reach = std::max({reach, pair.input.face_width[i] / 2, pair.face_widths.both_flanks[i] / 2});
  }
  const Axis x = kFaces.across(-1.1 * reach, 1.1 * reach);
  Svg svg("faces", kFaces.width, kFaces.height(), "Faces and the lines of action on them",
          "For each gear its face from end to end, and the parts that the leading and the trailing "
          "line of action use.");
  draw_foot(svg, x, kFaces.top - 14, kFaces.bottom(), 8,
            "along each gear’s axis from the common perpendicular, mm");
  for (const std::size_t i : {0u, 1u}) {
    const double top = kFaces.top + static_cast<double>(i) * kRow;
    const double half = pair.input.face_width[i] / 2;
    svg.rect(x(-half), top, x(half) - x(-half), 2 * kStrip, std::string("face ") + kInk[i]);
    svg.text({8, top + kStrip + 4}, fmt::format("Gear {}", i + 1), Anchor::start,
             std::string("panel ") + kInk[i]);
    draw_use(svg, pair, i, true, x, top + kStrip / 2);
    draw_use(svg, pair, i, false, x, top + 3 * kStrip / 2);
  }
  svg.line({x(0), kFaces.top - 14}, {x(0), kFaces.bottom()}, "thin dashdot");
  return svg.str();
}

// Describes the parts of the lines outside the faces.
std::string beyond(const CrossedPair& pair) {
  std::string text;
  for (const std::size_t i : {0u, 1u}) {
    const double more = (pair.face_widths.both_flanks[i] - pair.input.face_width[i]) / 2;
    if (more > 0.0)
      text +=
          fmt::format(" Gear {}: its lines reach {} mm beyond the face.", i + 1, fixed(more, 2));
  }
  return text.empty() ? " Both lines lie within both faces." : text;
}

constexpr int kSpeedSteps = 96;

// Sliding of flank 1 over flank 2, mm per radian of gear 1.
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

// Distance from C along the line of action, mm.
double along_line(const CrossedPair& pair, double rho1) {
  return (rho1 - pair.mesh.rho1_C) / std::cos(pair.input.gears[0].helix_angle);
}

Figure speed_figure(const CrossedPair& pair) {
  const Mesh<double>& m = pair.mesh;
  Figure f{"speeds",
           "Sliding of the flanks",
           "Sliding speeds across and along the teeth and in total, over the line of action from A "
           "to E.",
           ", gear 1 over gear 2.",
           {"distance from the pitch point C along the line of action", "mm"},
           {"sliding", "mm per radian of gear 1"}};
  std::array<std::vector<Vec2>, 3> curves;
  for (int k = 0; k <= kSpeedSteps; ++k) {
    const double rho1 = m.rho1_A + k * m.path_length / kSpeedSteps;
    const Sliding s = sliding_at(pair, rho1);
    const double at = along_line(pair, rho1);
    curves[0].push_back({at, s.whole()});
    curves[1].push_back({at, s.across});
    curves[2].push_back({at, s.along});
  }
  f.line(std::move(curves[0]), "curve ink", "altogether");
  f.line(std::move(curves[1]), "curve action-curve", "across the teeth");
  f.line(std::move(curves[2]), "curve trailing-curve dash", "along the teeth");
  f.keys = {{"action", "across the teeth"},
            {"trailing", "along the teeth (dashed)"},
            {"ink", "altogether"}};
  fit_axes(f, 0.1);
  f.y.lo = std::min(f.y.lo, 0.0);
  std::vector<LetterAt> letters;
  for (const PathMark& k : path_marks(m, m.rho1_E))
    letters.push_back({k.letter, Vec2(along_line(pair, k.rho1), -kInfinity)});
  add_letters(f, letters);
  return f;
}

std::string speed_table(const CrossedPair& pair) {
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

std::string face_width_figure(const CrossedPair& pair) {
  return captioned(
      widths_svg(pair),
      fmt::format("<strong>Face widths</strong> required by the lines of action, free of backlash: "
                  "full for one flank ({}), dashed for both flanks about the common perpendicular "
                  "({}). {}{}{}",
                  symbol_html("f"), symbol_html("f′"), caption_of_gears(),
                  pair.flanks_meet() ? " Dots: as mounted." : "",
                  pair.contact_ratio_range ? " Shaded: the contact ratio is at least 1." : ""));
}

std::string face_use_figure(const CrossedPair& pair) {
  GW_EXPECTS(pair.flanks_meet());
  return captioned(faces_svg(pair),
                   fmt::format("<strong>Use of the faces</strong> as mounted. {} {} Thick: within "
                               "usable flanks and faces.{}",
                               caption_key("action", "leading flanks A–E"),
                               caption_key("trailing", "trailing flanks A′–E′"), beyond(pair)));
}

std::string speed_figures(const CrossedPair& pair) {
  GW_EXPECTS(pair.flanks_meet());
  return figure_html(speed_figure(pair), 640.0) + speed_table(pair);
}

}  // namespace gearwright
