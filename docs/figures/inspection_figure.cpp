// Page 10: a span over four teeth as a length on the base tangent, and a ball in a space. The
// centre of the ball is the point where the parallel curves of both involutes intersect.
#include <cmath>

#include "docs/figures/figure.hpp"
#include "gearwright/inspection/balls.hpp"
#include "gearwright/inspection/span.hpp"

namespace gearwright::figures {

namespace {

constexpr double kScale = 9.2;  // px/mm

// Returns the involute of the flank on the side `hand` of the tooth whose centre line has the polar
// angle `turned`, from roll angle a to b. It is moved outward along its normal by `off`.
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

Figure span_figure(const Gear& gear) {
  const Span span = *usual_span(gear);
  const double r_b = gear.base_radius(), half = span.length / 2;
  const double pitch = 2 * kPi / gear.spec.teeth;
  Figure f = plane_figure("span", "A span", "Two anvils over four teeth.",
                          window({0, r_b}, {480, 470}, kScale));
  // The middle of the group of teeth between the anvils points up.
  add_gear(f, gear, "span-gear", "body outline g1", Vec2::Zero(),
           kHalfPi - (span.teeth - 1) * pitch / 2);
  f.circle(Vec2::Zero(), r_b, "thin dash", -1);
  f.circle(Vec2::Zero(), span.contact_diameter / 2, "thin dashdot", -1);
  for (const double x : {-half, half}) {
    f.line({{x, r_b - 9}, {x, r_b + 11}}, "curve ink bold");
    f.dot({x, r_b}, 4.5, "mark action-dot");
  }
  f.line({{-half, r_b}, {half, r_b}}, "curve action-curve");
  add_arrow(f, {{-half, r_b + 10}, {half, r_b + 10}}, "one", true);
  f.text({0, r_b + 10}, markup("{W_k}, k = " + std::to_string(span.teeth)), Anchor::middle,
         "letter halo", {0, -8});
  f.text({0, r_b}, "base tangent", Anchor::middle, "halo here", {0, 18});
  f.text({half, r_b}, markup("{d_M}"), Anchor::start, "halo", {10, 5});
  f.text(polar(r_b, kHalfPi - 0.3), markup("{d_b}"), Anchor::start, "halo", {6, 10});
  return f;
}

Figure ball_figure(const Gear& gear) {
  const double pitch = 2 * kPi / gear.spec.teeth;
  const auto ball = ball_in_space(gear, ball_sizes(gear)->ideal);
  const BallSeat& seat = *ball;
  const double r_K = seat.center_diameter / 2, r = seat.ball_diameter / 2, r_b = gear.base_radius();
  Figure f = plane_figure("ball", "A ball", "A ball in a space.",
                          window({0, gear.reference_diameter / 2 + 1.8}, {420, 470}, 2.9 * kScale));
  add_gear(f, gear, "ball-gear", "body outline g1", Vec2::Zero(), kHalfPi + pitch / 2);
  f.circle(Vec2::Zero(), r_b, "thin dash", -1);
  f.circle(Vec2::Zero(), r_K, "thin dashdot", -1);
  const Vec2 center(0, r_K);
  f.circle(center, r, "one", -1);
  const double alpha = seat.center_pressure_angle, end = std::tan(alpha) + 0.18;
  for (const int hand : {1, -1}) {
    const double tooth = kHalfPi - hand * pitch / 2;
    f.line(involute_points(gear, hand, tooth, 0, 0.05, end), "curve g1");
    f.line(involute_points(gear, hand, tooth, r, 0.15, end), "action-line");
    // The point of contact lies on the normal through the ball's centre, which is tangent to the
    // base circle.
    const Vec2 foot = polar(r_b, kHalfPi + hand * alpha);
    f.line({center, foot}, "curve action-curve fine");
    f.dot(center + (foot - center).normalized() * r, 4.5, "mark action-dot");
  }
  f.dot(center, 4.5, "mark action-dot");
  f.text(center, markup("{d_K}"), Anchor::start, "halo", {12, -8});
  f.text({0, r_K + r}, markup("{D_M}"), Anchor::middle, "letter halo", {0, -8});
  f.text(polar(r_b, kHalfPi - 0.13), markup("{d_b}"), Anchor::start, "halo", {8, 12});
  f.text({kInfinity, -kInfinity}, "24 teeth, x = 0.4", Anchor::end, "tick halo", {-14, -10});
  return f;
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
  f.add(span_figure(gear), {0, 0}, 480);
  f.add(ball_figure(gear), {480, 0}, 420);
  return f;
}

}  // namespace gearwright::figures
