// Page 1: the frames of two mounted gears at rotation 0, how they turn, and the line of action.
#include <cmath>

#include "docs/figures/figure.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright::figures {

Drawing frames_figure() {
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
  Figure f = plane_figure("01-frames", "Frames of a mounted pair at rest",
                          "Two spur gears of 12 and 18 teeth in the section z = 0: housing frame, "
                          "gear frames, senses of rotation, line of action from A to E.",
                          window({93, 0}, {860, 540}, 2.5));
  const double turned = pair.pose_2().turn();
  const Vec2 o_1 = Vec2::Zero(), o_2(a, 0);

  add_gear(f, one, "one", "body outline g1", o_1, 0);
  add_gear(f, two, "two", "body outline g2", o_2, turned);
  add_gear(f, one, "one-tooth", "curve g1", o_1, 0);
  add_gear(f, two, "two-tooth", "curve g2", o_2, turned);
  f.line({Vec2(-78, 0), Vec2(a + 108, 0)}, "thin dashdot");

  // Frames.
  const auto axis = [&](const Vec2& from, const Vec2& to, const char* words, const Vec2& offset,
                        const char* style, const char* text) {
    add_arrow(f, {from, to}, style);
    f.text(to, markup(words), Anchor::start, text, offset);
  };
  axis(o_1, {42, 0}, "{x}, {x_1}", {-22, -9}, "curve ink", "halo");
  axis(o_1, {0, 42}, "{y}, {y_1}", {8, 4}, "curve ink", "halo");
  axis(o_2, o_2 + polar(45, turned), "{x_2}", {-6, -10}, "curve g2", "halo g2");
  axis(o_2, o_2 + polar(45, turned + kHalfPi), "{y_2}", {8, 6}, "curve g2", "halo g2");
  f.dot(o_1, 4, "mark");
  f.dot(o_2, 4, "mark");
  f.text(o_1, "axis 1", Anchor::end, "halo", {-8, 19});
  f.text(o_2, markup("axis 2, ({a}, 0, 0)"), Anchor::start, "halo", {8, 20});
  f.text({one.tip_diameter / 2 - 4, 0}, "tooth 0", Anchor::end, "halo g1", {-30, 17});
  f.text(o_2 + polar(two.tip_diameter / 2 - 15, turned), "tooth 0", Anchor::start, "halo g2",
         {2, -12});

  // Directions of rotation.
  add_arrow(f, arc_points(o_1, 26, 2.6, 1.75), "curve g1");
  f.text(polar(30, 2.3), markup("{φ1}"), Anchor::end, "halo g1", {-3, -4});
  add_arrow(f, arc_points(o_2, 30, 0.55, 1.35), "curve g2");
  f.text(o_2 + polar(33, 0.95), markup("{φ2}"), Anchor::start, "halo g2", {3, -4});

  // The line of action, pitch circles and the normal.
  const auto on = [&](double rho) {
    const Vec3 p = pair.on_line_of_action(rho).r;
    return Vec2(p.x(), p.y());
  };
  f.circle(o_1, pair.mesh.rack.sides[0].pitch_radius, "thin g1 dashdot", 0);
  f.circle(o_2, pair.mesh.rack.sides[1].pitch_radius, "thin g2 dashdot", 1);
  f.line({on(0), on(pair.mesh.base_tangent_distance)}, "action-line");
  f.line({on(pair.mesh.rho1_A), on(pair.mesh.rho1_E)}, "action");
  for (const auto& [rho, word, offset] : {std::tuple(pair.mesh.rho1_A, "A", Vec2(-15, -2)),
                                          std::tuple(pair.mesh.rho1_C, "C", Vec2(9, -7)),
                                          std::tuple(pair.mesh.rho1_E, "E", Vec2(9, 10))}) {
    f.dot(on(rho), 3.5, "mark action-dot");
    f.text(on(rho), word, Anchor::start, "letter halo here", offset);
  }
  const double alpha = pair.mesh.rack.sides[0].transverse_angle;
  const Vec2 n(std::sin(alpha), -std::cos(alpha));
  const Vec2 e = on(pair.mesh.rho1_E) + 2 * n;
  add_arrow(f, {e, e + 22 * n}, "curve ink");
  f.text(e + 22 * n, markup("{n}"), Anchor::start, "halo", {6, 8});
  f.text({-kInfinity, kInfinity}, "section z = 0 at rotation 0, seen from +z", Anchor::start,
         "tick halo", {14, 24});
  f.text({kInfinity, -kInfinity}, "12 : 18 teeth, no backlash", Anchor::end, "tick halo",
         {-14, -10});
  return {f, 860};
}

}  // namespace gearwright::figures
