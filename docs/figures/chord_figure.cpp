// Page 5: the chord that a calliper measures, and the errors of formulas for a calculation by hand.
// Left: the unrolled cylinder with both flanks and the shortest chord between them. Right: the
// errors of the series and of virtual gears.
#include <array>
#include <cmath>

#include "docs/figures/figure.hpp"
#include "gearwright/inspection/chord_series.hpp"
#include "gearwright/inspection/chordal_thickness.hpp"

namespace gearwright::figures {

Drawing chord_figure() {
  Drawing f(
      "05-approximations", 860, 500, "The shortest chord and its approximations",
      "Both flanks of a tooth on an unrolled cylinder with the shortest chord between them, and "
      "the relative errors of the approximations over the half angle of the tooth.");
  const double psi = Angle::degrees(35.2644).rad();  // where the series converge worst [T5.11]

  // Left: the radius is 1, the half angle 0.6. The flanks are the helices θ = ±θ_t − ζ tan ψ.
  const double theta_t = 0.6;
  const double theta = shortest_chord_half_angle(theta_t, std::tan(psi) * std::tan(psi));
  const double zeta = (theta_t - theta) / std::tan(psi);
  const double reach = 0.56;
  Figure tooth = plane_figure("tooth", "The tooth on its cylinder, unrolled",
                              "Both flanks of a tooth on the unrolled cylinder, and the chord.",
                              window({0.02, 0.03}, {405, 500}, 195));
  // The helices rise to the left, so the end of the chord on the right flank is the higher one.
  for (const double side : {1.0, -1.0}) {
    const Vec2 foot(side * theta_t, 0), top(-reach * std::tan(psi), reach);
    tooth.line({foot - top, foot + top}, "curve g1");
  }
  tooth.line({{-0.82, 0}, {0.82, 0}}, "thin dashdot");
  tooth.line({{0, -0.7}, {0, 0.7}}, "thin dashdot");
  add_arrow(tooth, {{-theta_t, 0}, {theta_t, 0}}, "thin", true);
  add_arrow(tooth, {{-theta, -zeta}, {theta, zeta}}, "curve action-curve", true);
  const auto label = [&](const Vec2& at, const char* words, Anchor anchor, const Vec2& offset,
                         const char* style = "halo here") {
    tooth.text(at, markup(words), anchor, style, offset);
  };
  label({theta_t, 0}, "{θ_t}", Anchor::start, {8, -6}, "halo");
  label({theta, zeta}, "({θ*}, {ζ*})", Anchor::start, {8, -4});
  label({-theta, -zeta}, "(−{θ*}, −{ζ*})", Anchor::end, {-6, 18});
  label({0.55 * theta, 0.55 * zeta}, "shortest chord", Anchor::end, {-10, -12});
  label({0, kInfinity}, "the tooth on its cylinder, unrolled", Anchor::middle, {0, 30}, "halo");
  label({-0.82, 0}, "polar angle, rad", Anchor::start, {0, -8}, "tick halo");
  label({0, -0.7}, "height, in radii", Anchor::start, {8, -2}, "tick halo");
  label({theta_t - reach * std::tan(psi), reach}, "flank, {ψ} = 35.26°", Anchor::middle, {0, -10},
        "halo g1");
  f.add(tooth, {0, 0}, 405);

  // Right: relative errors of the chord.
  Figure errors{"errors",
                "Relative errors of the chord",
                "The relative errors over the half angle of the tooth.",
                "",
                {.words = "half angle of the tooth",
                 .unit = "rad",
                 .lo = 0.05,
                 .hi = 0.7,
                 .symbol = "θ_t",
                 .log = true},
                {.words = "relative error of the chord",
                 .unit = {},
                 .lo = 1e-12,
                 .hi = 1.0,
                 .symbol = "k*",
                 .log = true}};
  errors.tall = 1.05;
  name_decades(errors.y);
  const double base_helix = std::asin(std::sin(psi) * std::cos(Angle::degrees(20).rad()));
  const auto curve = [&](const auto& chord, const char* style) {
    std::vector<Vec2> points;
    for (int i = 0; i <= 60; ++i) {
      const double half = 0.05 * std::pow(0.7 / 0.05, i / 60.0);
      const double exact = shortest_chord(ToothArc<double>{half, psi, 1.0, 1.1}).chord;
      const double error = std::abs(chord(half) / exact - 1);
      if (error > 1e-12) points.push_back({half, error});
    }
    errors.line(std::move(points), style);
  };
  curve([&](double h) { return chord_by_series(h, psi, 1.0, 0).chord; }, "curve ink");
  curve([&](double h) { return virtual_spur_on_base_helix(h, psi, base_helix, 1.0).chord().chord; },
        "curve g2");
  curve([&](double h) { return virtual_spur(h, psi, 1.0).chord().chord; }, "curve g2 dash");
  constexpr std::array kStyles{"curve g1", "curve action-curve", "curve trailing-curve"};
  for (int n = 1; n <= 3; ++n)
    curve([&](double h) { return chord_by_series(h, psi, 1.0, n).chord; }, kStyles[n - 1]);
  errors.text({0.25, 1.5e-2}, markup("the arc {s_n}"), Anchor::end, "halo");
  errors.text({0.067, 9e-6}, "virtual gear [T5.14]", Anchor::start, "halo g2");
  errors.text({0.054, 2e-8}, "1 correction; dashed: virtual gear [T5.13]", Anchor::start,
              "halo g1");
  errors.text({0.23, 6e-7}, "2 corrections", Anchor::end, "halo here");
  errors.text({0.18, 5e-11}, "3 corrections [T5.9]", Anchor::start, "halo edge-c");
  f.add(errors, {410, 0}, 450);
  return f;
}

}  // namespace gearwright::figures
