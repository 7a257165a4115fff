// Page 5: the chord that a calliper measures, and the errors of formulas for a calculation by hand.
// Left: the unrolled cylinder with both flanks and the shortest chord between them. Right: the errors
// of the series and of virtual gears.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "docs/figures/figure.hpp"
#include "gearwright/inspection/chord_series.hpp"
#include "gearwright/inspection/chordal_thickness.hpp"

namespace gearwright::figures {

Figure chord_figure() {
  Figure f("05-approximations", 860, 500, "The shortest chord, exactly and by hand",
           "A tooth's two flanks on an unrolled cylinder with the shortest chord, and the relative "
           "errors of "
           "its approximations over the half angle of the tooth.");
  const double psi = Angle::degrees(35.2644).rad();  // where the series converge worst [T5.11]

  // Left: the radius is 1, the half angle 0.6. The flanks are the helices θ = ±θ_t − ζ tan ψ.
  const double theta_t = 0.6;
  const double theta = shortest_chord_half_angle(theta_t, std::tan(psi) * std::tan(psi));
  const double zeta = (theta_t - theta) / std::tan(psi);
  const double scale = 195;  // px per radius
  const auto px = [&](double angle, double height) {
    return Vec2(200 + scale * angle, 255 - scale * height);
  };
  // The helices rise to the left, so the end of the chord on the right flank is the higher one.
  const double reach = 0.56;
  for (const double side : {1.0, -1.0}) {
    std::vector<Vec2> flank;
    for (const double h : {-reach, reach})
      flank.push_back(px(side * theta_t - h * std::tan(psi), h));
    f.svg().polyline(flank, "g1 thick");
  }
  f.svg().line(px(-0.82, 0), px(0.82, 0), "soft dashdot thin");
  f.svg().line(px(0, -0.7), px(0, 0.7), "soft dashdot thin");
  f.arrow(px(-theta_t, 0), px(theta_t, 0), "soft", true);
  f.arrow(px(-theta, -zeta), px(theta, zeta), "action thick", true);
  f.label(px(theta_t, 0), "{θ_t}", Anchor::start, {8, -6}, "halo");
  f.label(px(theta, zeta), "({θ*}, {ζ*})", Anchor::start, {8, -4}, "action halo");
  f.label(px(-theta, -zeta), "(−{θ*}, −{ζ*})", Anchor::end, {-6, 18}, "action halo");
  f.label(px(0.55 * theta, 0.55 * zeta), "shortest chord", Anchor::end, {-10, -12}, "action halo");
  f.label({200, 40}, "the tooth on its cylinder, unrolled", Anchor::middle, Vec2::Zero(), "small");
  f.label(px(-0.82, 0), "polar angle, rad", Anchor::start, {0, -8}, "soft small halo");
  f.label(px(0, -0.7), "height, in radii", Anchor::start, {8, -2}, "soft small halo");
  f.label(px(-reach * std::tan(psi) + theta_t, reach), "flank, {ψ} = 35.26°", Anchor::middle,
          {0, -10}, "g1 small halo");

  // Right: relative errors of the chord, double logarithmic.
  const Plot plot{{std::log10(0.05), std::log10(0.7), 462, 826}, {-12, 0, 440, 36}};
  for (int p = -12; p <= 0; p += 2) {
    f.svg().line({plot.x.from, plot.y(p)}, {plot.x.to, plot.y(p)}, "rule grid");
    f.label({plot.x.from - 8, plot.y(p) + 4}, p == 0 ? "1" : fmt::format("1e{}", p), Anchor::end,
            Vec2::Zero(), "soft tick");
  }
  for (const char* text : {"0.05", "0.1", "0.2", "0.4", "0.7"}) {
    const double at = plot.x(std::log10(std::atof(text)));
    f.svg().line({at, plot.y.from}, {at, plot.y.to}, "rule grid");
    f.label({at, plot.y.from + 17}, text, Anchor::middle, Vec2::Zero(), "soft tick");
  }
  f.label({(plot.x.from + plot.x.to) / 2, plot.y.from + 38}, "half angle {θ_t} of the tooth, rad",
          Anchor::middle);
  f.label({plot.x.from, plot.y.to - 10}, "relative error of the chord {k*}, {ψ} = 35.26°");
  const double base_helix = std::asin(std::sin(psi) * std::cos(Angle::degrees(20).rad()));
  const auto curve = [&](const auto& chord, const char* style, const char* words,
                         const Vec2& offset, const char* text) {
    std::vector<Vec2> points;
    for (int i = 0; i <= 60; ++i) {
      const double lg = plot.x.lo + (plot.x.hi - plot.x.lo) * i / 60;
      const double half = std::pow(10.0, lg);
      const double exact = shortest_chord(ToothArc<double>{half, psi, 1.0, 1.1}).chord;
      const double error = std::abs(chord(half) / exact - 1);
      if (error > 1e-12) points.push_back(plot.px(lg, std::log10(error)));
    }
    f.svg().polyline(points, style);
    f.label(points[points.size() * 2 / 3], words, Anchor::end, offset, text);
  };
  curve([&](double h) { return chord_by_series(h, psi, 1.0, 0).chord; }, "soft thick",
        "the arc {s_n}", {-8, -6}, "soft small halo");
  curve([&](double h) { return virtual_spur_on_base_helix(h, psi, base_helix, 1.0).chord().chord; },
        "g2 thick", "virtual gear [T5.14]", {-4, -8}, "g2 small halo");
  curve([&](double h) { return virtual_spur(h, psi, 1.0).chord().chord; }, "g2 dash thick", "",
        {0, 0}, "small");
  const char* styles[] = {"g1 thick", "action thick", "green thick"};
  const char* texts[] = {"g1 small halo", "action small halo", "green small halo"};
  const char* names[] = {"1 correction, and virtual gear [T5.13]", "2 corrections",
                         "3 corrections [T5.9]"};
  for (int n = 1; n <= 3; ++n)
    curve([&](double h) { return chord_by_series(h, psi, 1.0, n).chord; }, styles[n - 1],
          names[n - 1], n == 1 ? Vec2(-8, -4) : Vec2(-10, -4), texts[n - 1]);
  return f;
}

}  // namespace gearwright::figures
