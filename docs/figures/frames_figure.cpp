// Page 1: the frames of two mounted gears at rotation 0, how they turn, and the line of action.
#include <cmath>
#include <numbers>

#include "docs/figures/figure.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright::figures {

Drawing frames_figure() {
  Drawing f("01-frames", 860, 540, "Frames of a mounted pair at rest",
            "Two spur gears of 12 and 18 teeth in the section z = 0: housing frame, gear frames, "
            "senses of rotation, line of action from A to E.");
  CylindricalSpec spec;
  spec.teeth = 12;
  spec.normal_module = 10;
  spec.profile_shift = 0.3;
  spec.face_width = 20;
  const Gear one = gear_of(spec);
  spec.teeth = 18;
  spec.profile_shift = 0.1;
  const Gear two = gear_of(spec);
  const double a = tight_center_distance(12, 18, 10.0, spec.normal_pressure_angle.rad(),
                                         spec.normal_pressure_angle.rad(), 1.0, 0.4);
  const auto mounted = mount_as<ParallelPair>(one, two, {.center_distance = a});
  const InvolutePair& pair = *mounted;
  const Viewport view{860, 540, {93, 0}, 2.5};
  const auto at_2 = [&](const Vec2& p) {
    const Vec3 q = (pair.pose_2() * Point<Gear2>{Vec3(p.x(), p.y(), 0)}).r;
    return Vec2(q.x(), q.y());
  };
  const double turned =
      std::atan2(at_2({1, 0}).y() - at_2({0, 0}).y(), at_2({1, 0}).x() - at_2({0, 0}).x());
  const Vec2 o_2(a, 0);

  f.shape(view, teeth(one, 0, 11, 0, 0.01), "body1 g1");
  f.shape(view, placed(teeth(two, 0, 17, turned, 0.01), 0, o_2), "body2 g2");
  f.line(view, teeth(one, 0, 0, 0, 0.01), "g1 heavy");
  f.line(view, placed(teeth(two, 0, 0, turned, 0.01), 0, o_2), "g2 heavy");
  f.line(view, {Vec2(-78, 0), Vec2(a + 108, 0)}, "soft dashdot thin");

  // Frames.
  const auto axis = [&](const Vec2& from, const Vec2& to, std::string_view words,
                        const Vec2& offset, std::string_view style, std::string_view text) {
    f.arrow(view.px(from), view.px(to), style);
    f.label(view.px(to), words, Anchor::start, offset, text);
  };
  axis({0, 0}, {42, 0}, "{x}, {x_1}", {-22, -9}, "ink thick", "halo");
  axis({0, 0}, {0, 42}, "{y}, {y_1}", {8, 4}, "ink thick", "halo");
  axis(o_2, o_2 + polar(45, turned), "{x_2}", {-6, -10}, "g2 thick", "g2 halo");
  axis(o_2, o_2 + polar(45, turned + std::numbers::pi / 2), "{y_2}", {8, 6}, "g2 thick", "g2 halo");
  f.dot(view, {0, 0}, "fill-ink", 4);
  f.dot(view, o_2, "fill-ink", 4);
  f.label(view.px({0, 0}), "axis 1", Anchor::end, {-8, 19}, "halo");
  f.label(view.px(o_2), "axis 2, ({a}, 0, 0)", Anchor::start, {8, 20}, "halo");
  f.label(view.px({one.tip_diameter / 2 - 4, 0}), "tooth 0", Anchor::end, {-30, 17},
          "g1 halo small");
  f.label(view.px(o_2 + polar(two.tip_diameter / 2 - 15, turned)), "tooth 0", Anchor::start,
          {2, -12}, "g2 halo small");

  // Directions of rotation.
  f.arc(view, {0, 0}, 26, 2.6, 1.75, "g1 thick", true);
  f.label(view.px(polar(30, 2.3)), "{φ1}", Anchor::end, {-3, -4}, "g1 halo");
  f.arc(view, o_2, 30, 0.55, 1.35, "g2 thick", true);
  f.label(view.px(o_2 + polar(33, 0.95)), "{φ2}", Anchor::start, {3, -4}, "g2 halo");

  // The line of action, pitch circles and the normal.
  const auto on = [&](double rho) {
    const Vec3 p = pair.on_line_of_action(rho).r;
    return Vec2(p.x(), p.y());
  };
  f.circle(view, {0, 0}, pair.mesh.rack.sides[0].pitch_radius, "g1 dashdot thin");
  f.circle(view, o_2, pair.mesh.rack.sides[1].pitch_radius, "g2 dashdot thin");
  f.line(view, {on(0), on(pair.mesh.base_tangent_distance)}, "action dot");
  f.line(view, {on(pair.mesh.rho1_A), on(pair.mesh.rho1_E)}, "action heavy");
  for (const auto& [rho, word, offset] : {std::tuple(pair.mesh.rho1_A, "A", Vec2(-15, -2)),
                                          std::tuple(pair.mesh.rho1_C, "C", Vec2(9, -7)),
                                          std::tuple(pair.mesh.rho1_E, "E", Vec2(9, 10))}) {
    f.dot(view, on(rho), "fill-action");
    f.label(view.px(on(rho)), word, Anchor::start, offset, "action bold halo");
  }
  const double alpha = pair.mesh.rack.sides[0].transverse_angle;
  const Vec2 n(std::sin(alpha), -std::cos(alpha));
  const Vec2 e = on(pair.mesh.rho1_E) + 2 * n;
  f.arrow(view.px(e), view.px(e + 22 * n), "ink thick");
  f.label(view.px(e + 22 * n), "{n}", Anchor::start, {6, 8}, "halo");
  f.label({14, 24}, "section z = 0 at rotation 0, seen from +z", Anchor::start, Vec2::Zero(),
          "soft small");
  f.label({846, 530}, "12 : 18 teeth, no backlash", Anchor::end, Vec2::Zero(), "soft small");
  return f;
}

}  // namespace gearwright::figures
