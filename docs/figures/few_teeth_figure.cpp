// Page 6: the pinion of two teeth of the example in the paper. Left: its circular fillets, tangent to the
// involute. Right: the pinion in mesh with the wheel of sixty teeth that it has cut.
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "docs/figures/figure.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/generation/circular_fillets.hpp"

namespace gearwright::figures {

Figure few_teeth_figure() {
  Figure f("06-few-teeth", 860, 500, "A pinion of two teeth and the wheel that it cuts",
           "Left the tooth of a two-tooth pinion with the circles of its fillets, right the pinion "
           "in its wheel of "
           "sixty teeth.");
  CylindricalSpec spec;  // Table 1 of Chen and Tsay
  spec.teeth = 2;
  spec.normal_module = 1.75;
  spec.helix_angle = Angle::degrees(30);
  spec.profile_shift = 0.7;
  spec.face_width = 12;
  spec.straight_rack().dedendum = 1.0;
  spec.straight_rack().root_fillet_radius = 0;
  spec.root_fillet = RootFilletSpec{0.01};
  spec.tip_fillet = TipFilletSpec{TipFilletSpec::By::radius, 0.332};
  const Gear pinion = gear_of(spec);
  const auto distance = generating_distance(pinion, 60, -1.4);
  if (!distance) throw std::logic_error(distance.error().message());
  PinionCutSpec cut;
  cut.teeth = 60;
  cut.distance = *distance;
  cut.face_width = 12;
  const auto wheel = make_pinion_cut_gear(pinion, cut);
  if (!wheel) throw std::logic_error(wheel.error().message());

  // Left: the tooth points up.
  {
    const Viewport view{420, 500, {1.45, 0.25}, 60, true};
    f.shape(view, teeth(pinion, 0, 1, 0, 0.001), "body1 g1");
    const Arc& arc = *pinion.tooth->outline.find(ArcName::flank);
    const double r_b = pinion.base_radius();
    const double psi_b = pinion.reference().base_tooth_thickness / pinion.reference().base_diameter;
    const Involute flank(r_b, psi_b);
    const double xi_c = flank.roll_at(arc.begin_point.norm());
    const double xi_j = flank.roll_at(arc.end_point.norm());
    const auto root = root_fillet_at(flank, 2, xi_c);
    const auto tip = tip_fillet_at(flank, xi_j);
    if (!root || !tip) throw std::logic_error("the figure's fillets do not exist");
    f.circle(view, {0, 0}, r_b, "green dash");
    f.line(view, {Vec2(-4, 0), Vec2(5.2, 0)}, "soft dashdot thin");
    f.line(view, {Vec2(0, -3), Vec2(0, 3.6)}, "soft dashdot thin");
    const Vec2 o_r = polar(root->distance, std::numbers::pi / 2);
    const Vec2 o_t = polar(tip->distance, 0);
    const Vec2 c = arc.begin_point;
    const Vec2 j = arc.end_point;
    f.circle(view, o_r, root->radius, "g2 dash");
    f.circle(view, o_t, tip->radius, "action dash");
    // The normals at C and J touch the base circle. Each contains the centre of its fillet.
    const Vec2 at_c = polar(r_b, psi_b - xi_c);
    const Vec2 at_j = polar(r_b, psi_b - xi_j);
    f.line(view, {at_c, o_r}, "g2");
    f.line(view, {at_j, j}, "action");
    for (const Vec2& p : {c, o_r}) f.dot(view, p, "fill-g2");
    for (const Vec2& p : {j, o_t}) f.dot(view, p, "fill-action");
    f.label(view.px(c), "C", Anchor::end, {-8, -4}, "g2 bold halo");
    f.label(view.px(j), "J", Anchor::end, {-8, 2}, "action bold halo");
    f.label(view.px(o_r), "root fillet, {r_r}", Anchor::middle, {4, -12}, "g2 small halo");
    f.label(view.px(o_t), "tip fillet, {r_t}", Anchor::start, {26, -4}, "action small halo");
    f.label(view.px(polar(r_b, -1.0)), "{d_b}", Anchor::start, {6, 14}, "green halo");
    f.label(view.px(flank.point(0.5 * (xi_c + xi_j))), "involute", Anchor::end, {-12, -6},
            "g1 small halo");
    f.label({14, 24}, "both circles are centred on a normal of the flank", Anchor::start,
            Vec2::Zero(), "small");
  }

  // Right: the mesh without backlash, seen along the axes.
  {
    f.svg().begin_clip(432, 0, 428, 500);
    const Viewport view{860 + 430, 500, {3.1, 0}, 28};
    const double turn = -0.5;
    const Vec2 o_2(*distance, 0);
    const double rest = std::numbers::pi * (1 - 1.0 / 60);
    std::vector<Vec2> body = placed(teeth(*wheel, -4, 4, rest - turn * 2 / 60, 0.002), 0, o_2);
    body.push_back(o_2);
    f.shape(view, body, "body2 g2");
    f.shape(view, teeth(pinion, 0, 1, turn, 0.002), "body1 g1");
    f.line(view, {Vec2(-6, 0), Vec2(12, 0)}, "soft dashdot thin");
    f.dot(view, {0, 0}, "fill-ink");
    f.svg().end_group();
    f.svg().line({432, 16}, {432, 484}, "rule");
    f.label({446, 24}, "2 : 60 teeth, module 1.75 mm, β = 30°, x = 0.7, −1.4", Anchor::start,
            Vec2::Zero(), "small halo");
  }
  return f;
}

}  // namespace gearwright::figures
