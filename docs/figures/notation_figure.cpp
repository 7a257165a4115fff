// Page 0: one tooth with the symbols of a gear. They are its circles, thicknesses and arcs, and the
// string whose end describes the involute.
#include <array>
#include <cmath>
#include <numbers>

#include "docs/figures/figure.hpp"

namespace gearwright::figures {

Drawing notation_figure() {
  Drawing f(
      "00-notation", 860, 560, "One tooth and its symbols",
      "Transverse section of a gear of 24 teeth: diameters, thicknesses, the arcs of the outline, "
      "and the string of the involute.");
  CylindricalSpec spec;
  spec.teeth = 24;
  spec.normal_module = 10;
  spec.profile_shift = 0.3;
  spec.face_width = 20;
  const Gear gear = gear_of(spec);
  const double r = gear.reference_diameter / 2;
  const double r_b = gear.base_radius();
  const double pitch = 2 * std::numbers::pi / gear.spec.teeth;
  const Viewport view{860, 560, {122.5, 0}, 13.6, true};
  std::vector<Vec2> body = teeth(gear, -2, 2, 0, 0.002);
  body.push_back(Vec2::Zero());
  f.shape(view, body, "body1 g1");

  // Circles, named at the right.
  struct Circle {
    double radius;
    const char *words, *style;
  };
  const std::array circles{
      Circle{gear.root_diameter / 2, "{d_f}", "soft"},        Circle{r_b, "{d_b}", "green dash"},
      Circle{*gear.root_form_radius(), "{d_Ff}", "soft dot"}, Circle{r, "{d}", "ink dashdot"},
      Circle{gear.tip_diameter / 2, "{d_a}", "soft"},
  };
  for (const Circle& c : circles) {
    f.circle(view, Vec2::Zero(), c.radius, c.style);
    const double right = (430.0 - 12.0) / view.scale;
    const Vec2 at = view.px({std::sqrt(c.radius * c.radius - right * right), -right});
    f.label(at, c.words, Anchor::end, {0, -6}, "halo");
  }

  // The arcs of the outline, on the side y > 0, with their names.
  const std::array styles{"action heavy", "g2 heavy", "g1 heavy", "green heavy"};
  const std::array names{"root land", "root fillet", "flank", "tip land"};
  const std::array words{"action halo", "g2 halo", "g1 halo", "green halo"};
  const std::array<Vec2, 4> offsets{Vec2(0, 20), Vec2(-12, 14), Vec2(-14, 0), Vec2(-4, -10)};
  std::size_t i = 0;
  for (const Arc& arc : gear.tooth->outline.arcs) {
    f.line(view, sample(arc, 40), styles[i]);
    f.label(view.px(arc.point(i == 2 ? 0.75 : 0.5)), names[i],
            i == 0 ? Anchor::middle : Anchor::end, offsets[i], words[i]);
    ++i;
  }

  // Thicknesses on the reference and the base circle, and the pitch.
  const double psi = gear.reference().reference_tooth_thickness_transverse / (2 * r);
  const double psi_b = gear.reference().base_tooth_thickness / (2 * r_b);
  f.arc(view, Vec2::Zero(), r, -psi, psi, "ink thick", 2);
  f.label(view.px(polar(r, 0)), "{s_t}", Anchor::start, {8, -7}, "halo");
  f.arc(view, Vec2::Zero(), r_b, -psi_b, psi_b, "green thick", 2);
  f.label(view.px(polar(r_b, 0)), "{s_bt} = 2{ψ_b}{r_b}", Anchor::start, {8, -7}, "green halo");
  f.arc(view, Vec2::Zero(), r - 1.7, -psi, -psi - pitch, "soft", 2);
  f.label(view.px(polar(r - 1.7, -psi - 0.5 * pitch)), "{p_t}", Anchor::middle, {0, 20}, "halo");
  f.line(view, {Vec2(100, 0), Vec2(150, 0)}, "soft dashdot thin");

  // The string from the base tangent point to a point Y of the flank on the side y < 0.
  const Vec2 at_tip = gear.tooth->outline.find(ArcName::flank)->end_point;
  const double rho_y = 0.5 * at_tip.norm() + 0.5 * r;
  const double xi = std::sqrt(rho_y * rho_y / (r_b * r_b) - 1);
  const Vec2 y = polar(rho_y, -(psi_b - (xi - std::atan(xi))));
  const Vec2 t = polar(r_b, -(psi_b - xi));
  f.line(view, {t, y}, "action thick");
  f.line(view, {Vec2::Zero(), y}, "soft thin");
  f.line(view, {Vec2::Zero(), t}, "soft thin");
  f.dot(view, y, "fill-action");
  f.dot(view, t, "fill-action");
  f.label(view.px(y), "Y", Anchor::start, {7, -5}, "action bold halo");
  f.label(view.px(0.45 * t + 0.55 * y), "{ρ} = {r_b}{ξ}", Anchor::end, {-10, -2}, "action halo");
  f.label({846, 548}, "24 teeth, x = 0.3", Anchor::end, Vec2::Zero(), "soft small");
  return f;
}

}  // namespace gearwright::figures
