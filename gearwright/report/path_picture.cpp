#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "gearwright/base/numbers.hpp"
#include "gearwright/figure/markup.hpp"
#include "gearwright/pair/drive.hpp"
#include "gearwright/pair/efficiency.hpp"
#include "gearwright/report/line_marks.hpp"
#include "gearwright/report/pair_figures.hpp"

namespace gearwright {

namespace {

constexpr double kDeepest = -8.0;  // least specific sliding at the lower end of the axis
// If a flank reaches a base tangent point, the specific sliding there decreases without bound.
// The range of the axis is then computed with this value.
constexpr double kEndless = -4.0;
constexpr double kRest = 1e-9;  // pitches; a shorter last piece of the path is a rounding error

// Adds a ruler along the path, which is divided into pieces of one transverse base pitch from A.
// The length of the last piece is the fractional part of the contact ratio.
FigureLane ruler_of(const Mesh<double>& mesh) {
  FigureLane ruler{"base pitches", {}};
  for (double from = 0.0; mesh.path_ratio - from > kRest; from += 1.0) {
    const double to = std::min(from + 1.0, mesh.path_ratio);
    const double begin = mesh.rho1_A - mesh.rho1_C;
    ruler.blocks.push_back({begin + from * mesh.step, begin + to * mesh.step, "region-map",
                            to - from < 1.0 ? fixed(to - from, 3) : "1"});
  }
  return ruler;
}

// Adds bars that show how many tooth pairs touch along the path. If only a shorter part of the path
// lies on the usable flanks, another bar shows this part.
void add_lanes(Figure& f, const Mesh<double>& mesh) {
  const auto from_C = [&](double rho1) { return rho1 - mesh.rho1_C; };
  const std::vector<ContactZone> zones = contact_zones(mesh.rho1_A, mesh.rho1_E, mesh.step);
  int most = 0;
  for (const ContactZone& zone : zones) most = std::max(most, zone.pairs);
  FigureLane pairs{"tooth pairs", {}};
  for (const ContactZone& zone : zones) {
    pairs.blocks.push_back({from_C(zone.begin), from_C(zone.end),
                            zone.pairs == 0      ? "zone none"
                            : zone.pairs == most ? "zone more"
                                                 : "zone fewer",
                            zone.pairs == 0 ? "no contact" : std::to_string(zone.pairs)});
  }
  f.lanes.push_back(std::move(pairs));
  f.lanes.push_back(ruler_of(mesh));
  const double clip = 1e-9 * mesh.path_length;
  if (mesh.rho1_true_begin <= mesh.rho1_A + clip && mesh.rho1_true_end >= mesh.rho1_E - clip)
    return;
  FigureLane usable{"usable flanks", {}};
  if (mesh.rho1_true_end > mesh.rho1_true_begin)
    usable.blocks.push_back(
        {from_C(mesh.rho1_true_begin), from_C(mesh.rho1_true_end), "lane inside", "touch"});
  else
    usable.blocks.push_back(
        {from_C(mesh.rho1_A), from_C(mesh.rho1_E), "zone none", "not on both gears"});
  f.lanes.push_back(std::move(usable));
}

std::optional<double> zeta(const InvolutePair& pair, int gear, double rho1) {
  const SpecificSliding<double> s = specific_sliding(pair.input, pair.mesh, rho1);
  return gear == 1 ? s.zeta_1 : s.zeta_2;
}

// Returns the lower end of the axis, a multiple of 0.5 slightly below the least sliding at A and E.
double lowest_shown(const InvolutePair& pair) {
  double low = -0.5;
  for (const SpecificSliding<double>& s : {pair.sliding_A, pair.sliding_E}) {
    for (const auto& z : {s.zeta_1, s.zeta_2}) low = std::min(low, z ? *z : kEndless);
  }
  return std::max(kDeepest, std::floor(2 * low - 0.3) / 2);
}

void add_sliding(Figure& f, const InvolutePair& pair, int gear) {
  constexpr int kSteps = 96;
  std::vector<Vec2> points;
  for (int k = 0; k <= kSteps; ++k) {
    const double rho1 = pair.mesh.rho1_A + k * pair.mesh.path_length / kSteps;
    const auto z = zeta(pair, gear, rho1);
    if (z && std::isfinite(*z))
      points.push_back({rho1 - pair.mesh.rho1_C, std::max(*z, 2 * kDeepest)});
  }
  f.line(std::move(points), gear == 1 ? "curve g1" : "curve g2 dash", fmt::format("gear {}", gear));
}

// Labels the values of both gears at one end of the path. Labels of values below the plot are at
// its lower border, one above the other.
void label_end(Figure& f, const InvolutePair& pair, bool at_A) {
  const double rho1 = contact_ends(pair)[at_A ? 0 : 1];
  const bool at_tip = rho1 == (at_A ? pair.mesh.rho1_A : pair.mesh.rho1_E);
  const char* name = at_A ? (at_tip ? "A" : "start") : (at_tip ? "E" : "end");
  const SpecificSliding<double>& s = at_A ? pair.sliding_A : pair.sliding_E;
  const std::array<std::optional<double>, 2> values{s.zeta_1, s.zeta_2};
  double lowest = -13.0;  // px, offset of the next label at the lower border
  for (const std::size_t i : {0u, 1u}) {
    const bool shown = values[i] && *values[i] >= f.y.lo;
    const double level = shown ? *values[i] : f.y.lo;
    const double away = !shown ? lowest : level > 0.0 ? -10.0 : 13.0;
    if (!shown) lowest -= 19.0;
    f.point({rho1 - pair.mesh.rho1_C, level}, shown ? 3.0 : 0.0, std::string("mark ") + kInk[i],
            symbol_svg(i == 0 ? "ζ_1" : "ζ_2") +
                fmt::format("({}) = {}", name, values[i] ? fixed(*values[i], 3) : "no involute"),
            {at_A ? 8.0 : -8.0, away});
    f.marks.back().label_style = std::string("halo ") + kInk[i];
  }
}

// Width of a character and of the space around a value, as fractions of the width of the plot.
constexpr double kCharacterWidth = 0.032, kSpace = 0.05;

}  // namespace

Figure path_figure(const InvolutePair& pair) {
  const Mesh<double>& mesh = pair.mesh;
  const double last = mesh.path_ratio < 1.0 ? std::max(mesh.rho1_E, mesh.rho1_D) : mesh.rho1_E;
  Figure f{
      "path",
      "Path of contact",
      "Specific sliding of both gears over the path of contact from A to E. Below the curves is "
      "the number of tooth pairs in contact.",
      ", with the number of tooth pairs in contact in one transverse section, and the specific "
      "sliding.",
      {"distance from the pitch point C along the line of action", "mm", mesh.rho1_A - mesh.rho1_C,
       last - mesh.rho1_C},
      {.words = "specific sliding",
       .unit = {},
       .lo = lowest_shown(pair),
       .hi = 1.0,
       .symbol = "ζ"}};
  f.keys = {{"line edge-g1", "gear 1"}, {"line dash edge-g2", "gear 2"}};
  std::vector<LetterAt> letters;
  for (const PathMark& m : path_marks(mesh, std::max(mesh.rho1_E, mesh.rho1_D)))
    letters.push_back({fmt::format("<tspan class=\"letter\">{}</tspan>", m.letter),
                       Vec2(m.rho1 - mesh.rho1_C, -kInfinity), "leader", "tick halo"});
  add_letters(f, letters);
  for (const int gear : {1, 2}) add_sliding(f, pair, gear);
  for (const bool at_A : {true, false}) label_end(f, pair, at_A);
  add_lanes(f, mesh);
  return f;
}

Figure ratio_figure(const InvolutePair& pair) {
  const Mesh<double>& mesh = pair.mesh;
  const double e_alpha = mesh.path_ratio, e_true = mesh.true_ratio, e_beta = mesh.overlap_ratio;
  const bool differs = std::abs(e_alpha - e_true) > 1e-9;
  Figure f{"ratios",
           "Contact ratios",
           "The bars show the transverse contact ratio, the overlap ratio and their sum. A line "
           "marks 1.",
           fmt::format(". If the ratio is at least 1, contact is continuous.{}",
                       differs ? " Filled bars are for the usable flanks, and outlined bars for "
                                 "the path from tip to tip, as in the formula."
                               : ""),
           {.words = "contact ratio", .unit = {}, .lo = 0.0, .hi = 2.0, .whole = true},
           {"", "", 0.0, 3.0}};
  f.keys = {{"alpha", "transverse"}, {"beta", "overlap"}};
  f.tall = 0.4;
  struct Bar {
    const char* words;
    const char* symbol;
    double from_alpha, from_beta, formula;
    double sum() const { return from_alpha + from_beta; }
    std::string value() const {
      return fixed(sum(), 3) + (formula - sum() > 1e-9 ? " of " + fixed(formula, 3) : "");
    }
    double room() const { return kCharacterWidth * static_cast<double>(value().size()) + kSpace; }
  };
  const std::array<Bar, 3> bars{{{"transverse", "ε_α", e_true, 0.0, e_alpha},
                                 {"overlap", "ε_β", 0.0, e_beta, e_beta},
                                 {"total", "ε_γ", e_true, e_beta, e_alpha + e_beta}}};
  for (const Bar& bar : bars)
    f.x.hi = std::max(f.x.hi, std::max(bar.sum(), bar.formula) / (1.0 - bar.room()));
  f.line({{1.0, -kInfinity}, {1.0, kInfinity}}, "one");
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const Bar& bar = bars[i];
    const double middle = 2.5 - static_cast<double>(i), low = middle - 0.3, high = middle + 0.3;
    f.y.names.push_back({middle, bar.words + (" " + symbol_svg(bar.symbol))});
    if (bar.from_alpha > 0.0) f.bar({0.0, low}, {bar.from_alpha, high}, "bar alpha");
    if (bar.from_beta > 0.0) f.bar({bar.from_alpha, low}, {bar.sum(), high}, "bar beta");
    if (bar.formula - bar.sum() > 1e-9) f.bar({0.0, low}, {bar.formula, high}, "bar formula");
    // If the line at 1 would cross a value, the value is written to the right of this line.
    const double end = std::max(bar.sum(), bar.formula);
    const bool crossed = end < 1.0 && end + bar.room() * f.x.hi > 1.0;
    f.text({crossed ? 1.0 : end, middle}, bar.value(), Anchor::start, "halo", {7.0, 5.0});
  }
  return f;
}

}  // namespace gearwright
