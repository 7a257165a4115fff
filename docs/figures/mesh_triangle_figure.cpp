// Page 2: the mesh triangle. The figure shows two base circles, their common tangent and the path of
// contact on it. The teeth are in contact at a point between B and C.
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <tuple>

#include "docs/figures/figure.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright::figures {

Figure mesh_triangle_figure() {
  Figure f("02-involute-and-pair", 860, 620, "The mesh triangle",
           "Base circles of a pair of 17 and 23 teeth, the line of action between their base "
           "tangent points, "
           "and the points A to E of the path of contact.");
  CylindricalSpec spec;
  spec.teeth = 17;
  spec.normal_module = 10;
  spec.profile_shift = 0.25;
  spec.face_width = 20;
  const Gear one = gear_of(spec);
  spec.teeth = 23;
  const Gear two = gear_of(spec);
  const double alpha_0 = spec.normal_pressure_angle.rad();
  const double a = tight_center_distance(17, 23, 10.0, alpha_0, alpha_0, 1.0, 0.5);
  const auto mounted = mount_as<ParallelPair>(one, two, {.center_distance = a});
  if (!mounted) throw std::logic_error(mounted.error().message());
  const InvolutePair& pair = *mounted;
  const Mesh<double>& m = pair.mesh;
  const Viewport view{860, 620, {a / 2 - 6, 8}, 3.7};

  // Gear 1 is turned until its leading flank touches at ρ_1. The flank passes C when the middle of the
  // tooth is half the tooth thickness, on the pitch circle, before the centre line.
  const double r_b1 = one.base_radius();
  const double alpha = m.rack.sides[0].transverse_angle;
  const double half =
      one.reference().base_tooth_thickness / one.reference().base_diameter - involute(alpha);
  const double rho = 0.6 * m.rho1_B + 0.4 * m.rho1_C;
  const double phi_1 = -half + (rho - m.rho1_C) / r_b1;
  const double rest_2 = std::numbers::pi * (1 - 1.0 / 23);
  const Vec2 o_2(a, 0);
  f.shape(view, teeth(one, 0, 16, -phi_1, 0.01), "body1 g1");
  f.shape(view, placed(teeth(two, 0, 22, rest_2 + phi_1 * 17 / 23, 0.01), 0, o_2), "body2 g2");

  f.circle(view, {0, 0}, r_b1, "g1 dash");
  f.circle(view, o_2, two.base_radius(), "g2 dash");
  f.circle(view, {0, 0}, one.tip_form_radius(), "g1 thin");
  f.circle(view, o_2, two.tip_form_radius(), "g2 thin");
  f.line(view, {Vec2(-30, 0), o_2 + Vec2(30, 0)}, "soft dashdot thin");

  const auto on = [&](double rho_1) {
    const Vec3 p = pair.on_line_of_action(rho_1).r;
    return Vec2(p.x(), p.y());
  };
  const Vec2 t_1 = on(0);
  const Vec2 t_2 = on(m.base_tangent_distance);
  f.line(view, {Vec2(0, 0), t_1}, "g1 thick");
  f.line(view, {o_2, t_2}, "g2 thick");
  f.line(view, {t_1, t_2}, "action dash");
  f.line(view, {on(m.rho1_A), on(m.rho1_E)}, "action heavy");
  f.label(view.px(0.5 * t_1), "{r_b1}", Anchor::end, {-8, -4}, "g1 halo");
  f.label(view.px(0.5 * (o_2 + t_2)), "{r_b2}", Anchor::start, {10, 10}, "g2 halo");
  f.arc(view, {0, 0}, 24, 0, alpha, "ink", true);
  f.label(view.px(polar(27, alpha / 2)), "{α_wt}", Anchor::start, {0, 4}, "halo");
  f.arc(view, o_2, 24, std::numbers::pi, std::numbers::pi + alpha, "ink", true);
  f.label(view.px(o_2 - polar(27, alpha / 2)), "{α_wt}", Anchor::end, {0, 6}, "halo");

  for (const auto& [at, word, offset] :
       {std::tuple(0.0, "{T_1}", Vec2(8, -8)), std::tuple(m.rho1_A, "A", Vec2(10, -3)),
        std::tuple(m.rho1_B, "B", Vec2(10, -3)), std::tuple(m.rho1_C, "C", Vec2(10, -6)),
        std::tuple(m.rho1_D, "D", Vec2(-21, 7)), std::tuple(m.rho1_E, "E", Vec2(10, 4)),
        std::tuple(m.base_tangent_distance, "{T_2}", Vec2(-24, 15))}) {
    f.dot(view, on(at), "fill-action", 4);
    f.label(view.px(on(at)), word, Anchor::start, offset, "action bold halo");
  }
  f.svg().circle(view.px(on(rho)), 7, "action thick");
  f.label(view.px(on(rho)), "touch: {ρ_1} from {T_1}, {ρ_2} from {T_2}", Anchor::end, {-16, -12},
          "action halo small");

  // N is drawn parallel to the line of action, a parallel to the centre line, each at some distance.
  const Vec2 across = 5.5 * Vec2(std::cos(alpha), std::sin(alpha));
  f.arrow(view.px(t_1 + across * 3.2), view.px(t_2 + across * 3.2), "soft", true);
  f.line(view, {t_1, t_1 + across * 3.6}, "soft thin");
  f.line(view, {t_2, t_2 + across * 3.6}, "soft thin");
  f.label(view.px(0.72 * t_1 + 0.28 * t_2 + across * 3.2), "{N} = {a} sin {α_wt}", Anchor::start,
          {10, -2}, "halo");
  f.arrow(view.px({0, -66}), view.px({a, -66}), "soft", true);
  f.line(view, {Vec2(0, 0), Vec2(0, -68)}, "soft thin");
  f.line(view, {o_2, Vec2(a, -68)}, "soft thin");
  f.label(view.px({a / 2, -66}), "{a}", Anchor::middle, {0, -7}, "halo");
  f.dot(view, {0, 0}, "fill-g1", 4);
  f.dot(view, o_2, "fill-g2", 4);
  f.label({846, 610}, "17 : 23 teeth, x = 0.25 each; gear 1 drives clockwise", Anchor::end,
          Vec2::Zero(), "soft small halo");
  return f;
}

}  // namespace gearwright::figures
