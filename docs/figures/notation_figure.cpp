// Page 0: one tooth with the symbols of a gear. They are its circles, thicknesses and arcs, and the
// string whose end describes the involute.
#include <array>
#include <cmath>

#include "docs/figures/figure.hpp"
#include "gearwright/figure/markup.hpp"
#include "gearwright/figure/mesh.hpp"
#include "gearwright/report/gear_figures.hpp"

namespace gearwright::figures {

Drawing notation_figure() {
  CylindricalSpec spec;
  spec.teeth = 24;
  spec.normal_module = 10;
  spec.profile_shift = 0.3;
  spec.face_width = 20;
  const Gear gear = gear_of(spec);
  const double r = gear.reference_diameter / 2;
  const double r_b = gear.base_radius();
  const double pitch = 2 * kPi / gear.spec.teeth;
  Figure f = plane_figure(
      "00-notation", "One tooth and its symbols",
      "Transverse section of a gear of 24 teeth: diameters, thicknesses, the arcs of the outline, "
      "and the string of the involute.",
      window({0, 122.5}, {860, 560}, 13.6));
  add_gear(f, gear, "gear", "body outline g1", Vec2::Zero(), kHalfPi);
  f.line({{0, 100}, {0, 150}}, "thin dashdot");

  // Circles, named at the right.
  const double right = f.x.hi - 0.9;
  for (const auto& [symbol, radius] :
       {std::pair("d_f", gear.root_diameter / 2), std::pair("d_b", r_b),
        std::pair("d_Ff", *gear.root_form_radius()), std::pair("d", r),
        std::pair("d_a", gear.tip_diameter / 2)}) {
    f.circle(Vec2::Zero(), radius, std::string("thin") + style_of_circle(symbol), -1);
    f.text({right, std::sqrt(radius * radius - right * right)}, symbol_svg(symbol), Anchor::end,
           "halo", {0, -6});
  }

  // The arcs of the outline, with their names on the left.
  add_upright_arcs(f, gear, arc_style);
  constexpr std::array names{"root land", "root fillet", "flank", "tip land"};
  const std::array<Vec2, 4> offsets{Vec2(0, 20), Vec2(-12, 14), Vec2(-14, 0), Vec2(-4, -10)};
  std::size_t i = 0;
  for (const Arc& arc : gear.tooth->outline.arcs) {
    const Vec2 at = upright(mirrored(arc.point(i == 2 ? 0.75 : 0.5)));
    f.text(at, names[i], i == 0 ? Anchor::middle : Anchor::end, "halo", offsets[i]);
    ++i;
  }

  // Thicknesses on the reference and the base circle, and the pitch. Angles are measured clockwise
  // from the centre line of the tooth.
  const auto at = [](double radius, double angle) { return polar(radius, kHalfPi - angle); };
  const auto thickness = [&](double radius, double from, double to, const char* style) {
    add_arrow(f, arc_points(Vec2::Zero(), radius, kHalfPi - from, kHalfPi - to), style, true);
  };
  const double psi = gear.reference().reference_tooth_thickness_transverse / (2 * r);
  const double psi_b = gear.reference().base_tooth_thickness / (2 * r_b);
  thickness(r, -psi, psi, "one");
  f.text(at(r, 0), markup("{s_t}"), Anchor::start, "halo", {8, -7});
  thickness(r_b, -psi_b, psi_b, "one");
  f.text(at(r_b, 0), markup("{s_bt} = 2{ψ_b}{r_b}"), Anchor::start, "halo", {8, -7});
  thickness(r - 1.7, psi, psi + pitch, "thin");
  f.text(at(r - 1.7, psi + 0.5 * pitch), markup("{p_t}"), Anchor::middle, "halo", {0, 20});

  // The string from the base tangent point to a point Y of the flank on the right.
  const Vec2 at_tip = gear.tooth->outline.find(ArcName::flank)->end_point;
  const double rho_y = 0.5 * at_tip.norm() + 0.5 * r;
  const double xi = std::sqrt(rho_y * rho_y / (r_b * r_b) - 1);
  const Vec2 y = at(rho_y, psi_b - (xi - std::atan(xi)));
  const Vec2 t = at(r_b, psi_b - xi);
  f.line({t, y}, "curve action-curve");
  f.line({y, Vec2::Zero(), t}, "thin");
  f.dot(y, 3.5, "mark action-dot");
  f.dot(t, 3.5, "mark action-dot");
  f.text(y, "Y", Anchor::start, "letter halo here", {7, -5});
  f.text(0.45 * t + 0.55 * y, markup("{ρ} = {r_b}{ξ}"), Anchor::end, "halo here", {-10, -2});
  f.text({kInfinity, -kInfinity}, "24 teeth, x = 0.3", Anchor::end, "tick halo", {-14, -12});
  return {f, 860};
}

}  // namespace gearwright::figures
