// Page 10: a span over four teeth as a length on the base tangent, and a ball in a space. The
// centre of the ball is the point where the parallel curves of both involutes intersect.
#include <cmath>
#include <numbers>

#include "docs/figures/figure.hpp"
#include "gearwright/inspection/balls.hpp"
#include "gearwright/inspection/span.hpp"

namespace gearwright::figures {

namespace {

constexpr double kScale = 9.2;  // px/mm

// Returns the involute of the flank on the side `hand` of the tooth turned by `turned`, from roll
// angle a to b. It is moved outward along its normal by `off`.
std::vector<Vec2> involute_points(const Gear& gear, int hand, double turned, double off, double a,
                                  double b) {
  const double r_b = gear.base_radius();
  const double half = gear.reference().base_tooth_thickness / gear.reference().base_diameter;
  std::vector<Vec2> points;
  for (int i = 0; i <= 60; ++i) {
    const double xi = a + (b - a) * i / 60;
    const double theta = turned + hand * (half + off / r_b - (xi - std::atan(xi)));
    points.push_back(polar(r_b * std::sqrt(1 + xi * xi), theta));
  }
  return points;
}

void draw_span(Drawing& f, const Gear& gear, const Viewport& view) {
  const Span span = *usual_span(gear);
  const double r_b = gear.base_radius(), half = span.length / 2;
  const double pitch = 2 * std::numbers::pi / gear.spec.teeth;
  // The middle of the group of teeth between the anvils points up.
  f.shape(view, teeth(gear, -2, span.teeth + 1, -(span.teeth - 1) * pitch / 2, 0.002), "body1");
  f.circle(view, {0, 0}, r_b, "green dash");
  f.circle(view, {0, 0}, span.contact_diameter / 2, "ink dashdot");
  for (const double side : {-1.0, 1.0}) {
    f.line(view, {{r_b - 9, side * half}, {r_b + 11, side * half}}, "ink heavy");
    f.dot(view, {r_b, side * half}, "fill-action", 4.5);
  }
  f.line(view, {{r_b, -half}, {r_b, half}}, "action thick");
  const Vec2 up = view.px({r_b + 10, 0});
  f.arrow(view.px({r_b + 10, half}), view.px({r_b + 10, -half}), "ink", true);
  f.label(up, "{W_k}, k = " + std::to_string(span.teeth), Anchor::middle, {0, -8}, "bold halo");
  f.label(view.px({r_b, 0}), "base tangent", Anchor::middle, {0, 18}, "action halo");
  f.label(view.px({r_b, -half}), "{d_M}", Anchor::start, {10, 5}, "halo");
  f.label(view.px(polar(r_b, -0.62)), "{d_b}", Anchor::start, {6, 10}, "green halo");
}

void draw_ball(Drawing& f, const Gear& gear, const Viewport& view) {
  const double pitch = 2 * std::numbers::pi / gear.spec.teeth;
  const auto ball = ball_in_space(gear, ball_sizes(gear)->ideal);
  const BallSeat& seat = *ball;
  f.shape(view, teeth(gear, -1, 0, pitch / 2, 0.002), "body1");
  const double r_K = seat.center_diameter / 2, r = seat.ball_diameter / 2;
  f.circle(view, {0, 0}, gear.base_radius(), "green dash");
  f.circle(view, {0, 0}, r_K, "ink dashdot");
  f.circle(view, {r_K, 0}, r, "ink thick");
  const double end = std::tan(seat.center_pressure_angle) + 0.18;
  for (const int hand : {1, -1}) {
    f.line(view, involute_points(gear, hand, -hand * pitch / 2, 0, 0.05, end), "g1 heavy");
    f.line(view, involute_points(gear, hand, -hand * pitch / 2, r, 0.15, end), "action dash");
    // The point of contact lies on the normal through the ball's centre, which is tangent to the
    // base circle.
    const double alpha = seat.center_pressure_angle;
    const Vec2 foot = polar(gear.base_radius(), hand * alpha);
    const Vec2 center{r_K, 0};
    const Vec2 contact = center + (foot - center).normalized() * r;
    f.line(view, {center, foot}, "action thin");
    f.dot(view, contact, "fill-action", 4.5);
  }
  f.dot(view, {r_K, 0}, "fill-action", 4.5);
  f.label(view.px({r_K, 0}), "{d_K}", Anchor::start, {12, -8}, "halo");
  f.label(view.px({r_K + r, 0}), "{D_M}", Anchor::middle, {0, -8}, "bold halo");
  f.label(view.px(polar(gear.base_radius(), -0.2)), "{d_b}", Anchor::start, {8, 12}, "green halo");
}

}  // namespace

Drawing inspection_figure() {
  Drawing f("10-inspection", 900, 470, "A span and a ball",
            "Left, two anvils over four teeth: the span is a length of the tangent of the base "
            "circle. Right, a ball in a space, touched where the normals of the parallel involutes "
            "meet the flanks.");
  CylindricalSpec spec;
  spec.teeth = 24;
  spec.normal_module = 4;
  spec.profile_shift = 0.4;
  spec.face_width = 20;
  const Gear gear = gear_of(spec);
  const double middle = gear.base_radius() + 2;
  const Viewport left{900, 470, {middle - 2, -22.8}, kScale, true};
  const Viewport right{900, 470, {gear.reference_diameter / 2 + 1.8, 8.7}, 2.9 * kScale, true};
  f.svg().begin_clip(0, 0, 480, 470);
  draw_span(f, gear, left);
  f.svg().end_group();
  f.svg().begin_clip(480, 0, 420, 470);
  draw_ball(f, gear, right);
  f.svg().end_group();
  f.label({886, 460}, "24 teeth, x = 0.4", Anchor::end, Vec2::Zero(), "soft small halo");
  return f;
}

}  // namespace gearwright::figures
