#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "gearwright/figure/free_labels.hpp"
#include "gearwright/pair/contact_zones.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/line_marks.hpp"
#include "gearwright/report/pair_figures.hpp"
#include "gearwright/report/plot_axis.hpp"

namespace gearwright {

namespace {

constexpr PlotArea kArea{640, 46, 22, 112, 230, 58};
constexpr double kStripTop = 34.0, kStripHeight = 26.0;
constexpr double kDeepest = -8.0;  // specific sliding at which a shown curve ends
// The same for a curve that falls without limit, towards a base tangent point.
constexpr double kEndless = -4.0;

std::string count_words(int pairs, double width) {
  if (pairs == 0) return width > 80 ? "no contact" : "0";
  if (width < 14) return "";
  if (width < 56) return std::to_string(pairs);
  return fmt::format("{} pair{}", pairs, pairs == 1 ? "" : "s");
}

void draw_strip(Svg& svg, const InvolutePair& pair, const Axis& x) {
  const Mesh<double>& mesh = pair.mesh;
  const std::vector<ContactZone> zones = contact_zones(mesh.rho1_A, mesh.rho1_E, mesh.step);
  int most = 0;
  for (const ContactZone& zone : zones) most = std::max(most, zone.pairs);
  for (const ContactZone& zone : zones) {
    const double left = x(zone.begin);
    const double width = x(zone.end) - left;
    svg.rect(left, kStripTop, width, kStripHeight,
             zone.pairs == 0      ? "zone none"
             : zone.pairs == most ? "zone more"
                                  : "zone fewer");
    svg.text({left + width / 2, kStripTop + kStripHeight / 2 + 5}, count_words(zone.pairs, width),
             Anchor::middle, "inzone");
  }
  const std::vector<PathMark> marks = path_marks(mesh, std::max(mesh.rho1_E, mesh.rho1_D));
  std::vector<double> wanted;
  for (const PathMark& m : marks) wanted.push_back(x(m.rho1));
  const std::vector<double> letters = spread(wanted, 16.0, 10.0, kArea.width - 10.0);
  const std::vector<double> values = spread(wanted, 58.0, 30.0, kArea.width - 30.0);
  const double foot = kArea.bottom();
  for (std::size_t i = 0; i < marks.size(); ++i) {
    svg.polyline({{letters[i], kStripTop - 9}, {wanted[i], kStripTop - 3}, {wanted[i], foot}},
                 "leader");
    svg.text({letters[i], kStripTop - 14}, marks[i].letter, Anchor::middle, "letter");
    svg.line({wanted[i], foot}, {values[i], foot + 10}, "leader");
    svg.text({values[i], foot + 23}, fixed(marks[i].rho1 - mesh.rho1_C, 3), Anchor::middle, "tick");
  }
  svg.text({(x.from + x.to) / 2, kArea.height() - 8},
           "distance from the pitch point C along the line of action, mm", Anchor::middle, "tick");

  // The remaining path after clipping to the usable flanks.
  const double clip = 1e-9 * mesh.path_length;
  const bool clipped =
      mesh.rho1_true_begin > mesh.rho1_A + clip || mesh.rho1_true_end < mesh.rho1_E - clip;
  if (!clipped) return;
  const double y = kStripTop + kStripHeight + 9;
  if (mesh.rho1_true_end > mesh.rho1_true_begin) {
    svg.line({x(mesh.rho1_true_begin), y}, {x(mesh.rho1_true_end), y}, "usable");
  }
  svg.text({(x(mesh.rho1_A) + x(mesh.rho1_E)) / 2, y + 18},
           mesh.rho1_true_end > mesh.rho1_true_begin ? "usable flanks touch along this part only"
                                                     : "no part where both flanks are usable",
           Anchor::middle, "tick halo");
}

std::optional<double> zeta(const InvolutePair& pair, int gear, double rho1) {
  const SpecificSliding<double> s = specific_sliding(pair.input, pair.mesh, rho1);
  return gear == 1 ? s.zeta_1 : s.zeta_2;
}

// The range begins at a multiple of one half slightly below the lower of the ends.
double lowest_shown(const InvolutePair& pair) {
  double low = -0.5;
  for (const SpecificSliding<double>& s : {pair.sliding_A, pair.sliding_E}) {
    for (const auto& z : {s.zeta_1, s.zeta_2}) low = std::min(low, z ? *z : kEndless);
  }
  return std::max(kDeepest, std::floor(2 * low - 0.3) / 2);
}

void draw_sliding(Svg& svg, const InvolutePair& pair, int gear, const Axis& x, const Axis& y) {
  constexpr int kSteps = 96;
  std::vector<Vec2> points;
  for (int k = 0; k <= kSteps; ++k) {
    const double t = static_cast<double>(k) / kSteps;
    const double rho1 = pair.mesh.rho1_A + t * pair.mesh.path_length;
    const auto z = zeta(pair, gear, rho1);
    if (z && std::isfinite(*z)) points.push_back({x(rho1), y(std::max(*z, 2 * kDeepest))});
  }
  if (points.size() > 1) svg.polyline(points, gear == 1 ? "curve g1" : "curve g2 dash");
}

// The four values at the ends, next to their curves and without overlap.
void label_end(Svg& svg, const InvolutePair& pair, bool at_A, const Axis& x, const Axis& y) {
  const double rho1 = at_A ? pair.mesh.rho1_A : pair.mesh.rho1_E;
  const SpecificSliding<double>& s = at_A ? pair.sliding_A : pair.sliding_E;
  const std::array<std::optional<double>, 2> values{s.zeta_1, s.zeta_2};
  std::vector<double> wanted;
  for (const auto& v : values) {
    const double shown = std::max(v.value_or(y.lo), y.lo);
    // Labels are below the end of a curve that rises from it and above the end of one that falls.
    wanted.push_back(y(shown) + (shown > 0.0 ? -10.0 : 13.0));
    if (v && *v >= y.lo) svg.dot({x(rho1), y(*v)}, 3.0, wanted.size() == 1 ? "mark g1" : "mark g2");
  }
  const std::vector<double> placed = spread(wanted, 17.0, kArea.top - 6, kArea.bottom() - 6);
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string value = values[i] ? fixed(*values[i], 3) : std::string("no involute");
    svg.text({x(rho1), placed[i]},
             symbol_svg(i == 0 ? "ζ_1" : "ζ_2") + fmt::format("({}) = {}", at_A ? "A" : "E", value),
             at_A ? Anchor::start : Anchor::end, i == 0 ? "halo g1" : "halo g2",
             {at_A ? 8.0 : -8.0, 4.0});
  }
}

std::string path_svg(const InvolutePair& pair) {
  const Mesh<double>& mesh = pair.mesh;
  const double end = std::max(mesh.rho1_E, mesh.rho1_D);
  const Axis x{mesh.rho1_A, std::max(mesh.rho1_E, mesh.path_ratio < 1.0 ? end : mesh.rho1_E),
               kArea.left + 14, kArea.width - kArea.right};
  const Axis y = kArea.up(lowest_shown(pair), 1.0);
  Svg svg(
      "path", kArea.width, kArea.height(), "Path of contact and specific sliding",
      "A strip from A to E with the number of tooth pairs in contact, and below it the specific "
      "sliding of both gears over the path.");
  const double step = y.hi - y.lo > 3.0 ? 1.0 : 0.5;
  for (double v = std::ceil(y.lo / step) * step; v <= 1.0; v += step) {
    svg.line({kArea.left, y(v)}, {kArea.width - kArea.right, y(v)}, v == 0.0 ? "axis" : "grid");
    svg.text({kArea.left - 6, y(v) + 4}, tick_text(v, 1), Anchor::end, "tick");
  }
  draw_strip(svg, pair, x);
  svg.begin_clip(kArea.left, kArea.top, kArea.width - kArea.right - kArea.left, kArea.tall);
  for (const int gear : {1, 2}) draw_sliding(svg, pair, gear, x, y);
  svg.end_group();
  for (const bool at_A : {true, false}) label_end(svg, pair, at_A, x, y);
  return svg.str();
}

std::string ratio_svg(const InvolutePair& pair) {
  const Mesh<double>& mesh = pair.mesh;
  const double e_alpha = mesh.path_ratio;
  const double e_true = mesh.true_ratio;
  const double e_beta = mesh.overlap_ratio;
  constexpr double kBarWidth = 420.0;  // equal to that of the picture of the whole pair, above it
  constexpr double kBarLeft = 136.0;
  constexpr double kBarRight = 122.0;
  constexpr double kRow = 34.0;
  constexpr double kTop = 26.0;
  constexpr double kOneRoom = 3.0;  // px between a value and the line at 1
  const double most =
      std::max(2.0, std::ceil(std::max(pair.contact_ratio(), pair.contact_ratio_true()) + 0.15));
  const Axis x{0.0, most, kBarLeft, kBarWidth - kBarRight};
  const double height = kTop + 3 * kRow + 10;
  Svg svg("ratios", kBarWidth, height, "Contact ratios",
          "Bars of the transverse contact ratio, the overlap ratio and their sum; a line marks 1.");
  const double by = std::ceil(most / 6);  // chosen so that adjacent numbers do not overlap
  for (double v = 0.0; v <= most; v += by) {
    svg.line({x(v), kTop - 6}, {x(v), height - 8}, "grid");
    svg.text({x(v), kTop - 11}, tick_text(v, 0), Anchor::middle, "tick");
  }
  svg.line({x(1.0), kTop - 6}, {x(1.0), height - 8}, "one");
  struct Bar {
    const char* words;
    const char* symbol;
    double from_alpha, from_beta, formula;
  };
  const std::array<Bar, 3> bars{{{"transverse", "ε_α", e_true, 0.0, e_alpha},
                                 {"overlap", "ε_β", 0.0, e_beta, e_beta},
                                 {"total", "ε_γ", e_true, e_beta, e_alpha + e_beta}}};
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const Bar& bar = bars[i];
    const double top = kTop + static_cast<double>(i) * kRow + 4;
    const double tall = kRow - 12;
    svg.text({12, top + 16}, bar.words);
    svg.text({kBarLeft - 12, top + 16}, symbol_svg(bar.symbol), Anchor::end);
    if (bar.from_alpha > 0.0) svg.rect(x(0), top, x(bar.from_alpha) - x(0), tall, "bar alpha");
    if (bar.from_beta > 0.0) {
      svg.rect(x(bar.from_alpha), top, x(bar.from_beta) - x(0), tall, "bar beta");
    }
    const double sum = bar.from_alpha + bar.from_beta;
    if (bar.formula - sum > 1e-9) svg.rect(x(0), top, x(bar.formula) - x(0), tall, "bar formula");
    std::string value = fixed(sum, 3);
    if (bar.formula - sum > 1e-9) value += " of " + fixed(bar.formula, 3);
    // A value that the line at 1 would cross is behind the line.
    const LabelPlace beside{{x(std::max(sum, bar.formula)), top + 16}, {7.0, 0.0}, Anchor::start};
    const PixelBox box = label_box(beside, value);
    const bool crossed = box.left - kOneRoom < x(1.0) && x(1.0) < box.right + kOneRoom;
    svg.text({crossed ? x(1.0) : beside.at.x(), beside.at.y()}, value, Anchor::start, "halo",
             beside.offset);
  }
  return svg.str();
}

}  // namespace

std::string path_figure(const InvolutePair& pair) {
  return captioned(path_svg(pair),
                   "<strong>Path of contact</strong>, zones of tooth pairs in contact in one "
                   "transverse section. Specific sliding: " +
                       caption_key("g1", "gear 1") + " " + caption_key("g2", "gear 2 (dashed)"));
}

std::string ratio_figure(const InvolutePair& pair) {
  const bool differs = std::abs(pair.mesh.path_ratio - pair.mesh.true_ratio) > 1e-9;
  const char* const filled =
      differs ? " Filled: of the usable flanks; outlined: from tip to tip, as in the formula." : "";
  return captioned(
      ratio_svg(pair),
      fmt::format("<strong>Contact ratios</strong>; from 1 on contact never stops.{} {} {}", filled,
                  caption_key("alpha", "transverse"), caption_key("beta", "overlap")));
}

}  // namespace gearwright
