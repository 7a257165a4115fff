#include "gearwright/report/turning.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "gearwright/report/pair_figures.hpp"
#include "gearwright/report/testing/sample_reports.hpp"

namespace gearwright {
namespace {

constexpr double kRadian = std::numbers::pi / 180.0;

// How far a point of the housing lies beside the leading flank of the gear's nearest tooth, mm,
// after gear 1 has turned by t pitches out of the drawn position.
double beside_flank(const InvolutePair& pair, std::size_t i, double t, const Vec2& point) {
  const Gear& gear = pair.gears[i];
  const Eigen::Isometry3d pose = i == 0 ? pair.pose_1().isometry() : pair.pose_2().isometry();
  const Vec2 arm = point - pose.translation().head<2>();
  // The picture turns clockwise for positive degrees.
  const double turned = rotation_to_pitch_point(pair)[i] - kRadian * turn_per_pitch(pair, i) * t;
  const double drawn = std::atan2(pose.linear()(1, 0), pose.linear()(0, 0)) + turned;
  const Arc* flank = gear.tooth->outline.find(ArcName::flank);
  const bool ring = gear.internal();
  const double xi = ring ? flank->curve->parameter_at_radius(arm.norm(), flank->end, flank->begin)
                         : flank->curve->parameter_at_radius(arm.norm(), flank->begin, flank->end);
  // Gear 1 pushes with its clockwise flanks and gear 2 is touched on its own, for it turns the
  // other way; an internal gear turns the same way and is touched on its counter-clockwise ones.
  const double half = (ring ? -1.0 : 1.0) * flank->curve->polar_angle(xi);
  const double pitch = 2 * std::numbers::pi / std::abs(gear.spec.teeth);
  const double angle = std::atan2(arm.y(), arm.x()) - drawn + half;
  return std::hypot(arm.norm() * std::remainder(angle, pitch),
                    flank->curve->point(xi).norm() - arm.norm());
}

TEST(Turning, FlanksStayInTouchAtTheRings) {
  for (const InvolutePair& pair :
       {testing::helical_pair(), testing::two_and_sixty(), testing::pinion_in_cut_ring()}) {
    const Mesh<double>& m = pair.mesh;
    int touches = 0;
    for (const double t : {0.0, 0.2, 0.55, 0.9}) {
      for (int k = -2; k <= 2; ++k) {
        const double rho1 = m.rho1_C + (t + k) * m.step;
        if (rho1 < m.rho1_true_begin || rho1 > m.rho1_true_end) continue;
        ++touches;
        const Vec2 p = pair.on_line_of_action(rho1).r.head<2>();
        EXPECT_LT(beside_flank(pair, 0, t, p), 1e-9);
        EXPECT_LT(beside_flank(pair, 1, t, p), 1e-9);
      }
    }
    EXPECT_GT(touches, 1);
  }
}

TEST(Turning, APitchAtATime) {
  const InvolutePair external = testing::two_and_sixty();
  EXPECT_EQ(turn_per_pitch(external, 0), 180.0);
  EXPECT_EQ(turn_per_pitch(external, 1), -6.0);
  const InvolutePair internal = testing::pinion_in_cut_ring();
  EXPECT_EQ(turn_per_pitch(internal, 0), 20.0);
  EXPECT_EQ(turn_per_pitch(internal, 1), 6.0);
  EXPECT_EQ(turn_attribute(external, 1), "data-turn=\"-6\"");
}

TEST(Turning, RingsForEveryToothThatPasses) {
  const auto rings = [](const InvolutePair& pair) {
    Svg svg("s", 100, 100, "t", "d");
    draw_touches(svg, {100, 100, Vec2::Zero(), 1.0}, pair);
    const std::string text = svg.str();
    std::size_t n = 0;
    for (std::size_t at = text.find("data-tooth"); at != text.npos;
         at = text.find("data-tooth", at + 1))
      ++n;
    return n;
  };
  // From −0.63 to 0.82 of a pitch; from −0.11 to 0.58; nothing where the flanks do not meet.
  EXPECT_EQ(rings(testing::helical_pair()), 2u);
  EXPECT_EQ(rings(testing::two_and_sixty()), 2u);
  EXPECT_EQ(rings(testing::sample_pair(testing::sample_gear(20, 2, 0, 0),
                                       testing::sample_gear(40, 2, 0, 0), 70)),
            0u);
}

TEST(Turning, StandsStillUntilAsked) {
  const std::string control = turn_control(testing::helical_pair());
  EXPECT_NE(control.find("hidden>"), control.npos);  // without the script there is nothing to press
  EXPECT_NE(control.find("type=\"range\""), control.npos);
  const std::string script(turn_script());
  EXPECT_NE(script.find("prefers-reduced-motion"), script.npos);
  EXPECT_NE(script.find("beforeprint"), script.npos);
  EXPECT_EQ(script.find("</"), script.npos);
}

}  // namespace
}  // namespace gearwright
