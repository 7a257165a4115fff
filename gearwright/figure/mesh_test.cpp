#include "gearwright/figure/mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/report/testing/sample_reports.hpp"

namespace gearwright {
namespace {

// Returns the point of the flank at a radius, on the side y > 0 of the tooth at the x axis.
Vec2 flank_point(const Gear& gear, double radius) {
  const Arc* flank = gear.tooth->outline.find(ArcName::flank);
  return flank->curve->point(flank->curve->parameter_at_radius(radius, flank->begin, flank->end));
}

Vec2 turned(const Vec2& p, double angle) {
  return {std::cos(angle) * p.x() - std::sin(angle) * p.y(),
          std::sin(angle) * p.x() + std::cos(angle) * p.y()};
}

TEST(MeshPicture, LeadingFlanksMeetAtThePitchPoint) {
  for (const InvolutePair& pair : {testing::helical_pair(), testing::undercut_pair()}) {
    const auto phi = rotation_to_pitch_point(pair);
    const Vec2 C = pair.on_line_of_action(pair.mesh.rho1_C).r.head<2>();
    // Gear 1 touches with the clockwise flank of tooth 0.
    Vec2 p1 = flank_point(pair.gears[0], pair.mesh.rack.sides[0].pitch_radius);
    p1.y() = -p1.y();
    EXPECT_LT((turned(p1, phi[0]) - C).norm(), 1e-9);
    // Gear 2 touches with the clockwise flank of tooth 1, the next tooth counter-clockwise from
    // space 0. Space 0 points to −x, so tooth 1 is below it.
    Vec2 p2 = flank_point(pair.gears[1], pair.mesh.rack.sides[1].pitch_radius);
    p2.y() = -p2.y();
    const double pitch = 2 * std::acos(-1.0) / pair.input.gears[1].teeth;
    const Vec3 local(turned(p2, pitch).x(), turned(p2, pitch).y(), 0.0);
    const Vec3 placed = pair.pose_2().isometry() * local;
    const Vec2 axis(pair.center_distance, 0.0);
    EXPECT_LT((axis + turned(placed.head<2>() - axis, phi[1]) - C).norm(), 1e-9);
  }
}

TEST(MeshPicture, PinionInItsRing) {
  const InvolutePair pair = testing::internal_pair();
  const auto phi = rotation_to_pitch_point(pair);
  const Vec2 C = pair.on_line_of_action(pair.mesh.rho1_C).r.head<2>();
  Vec2 p1 = flank_point(pair.gears[0], pair.mesh.rack.sides[0].pitch_radius);
  p1.y() = -p1.y();
  const Vec3 placed = pair.pose_1().isometry() * Vec3(p1.x(), p1.y(), 0.0);
  EXPECT_LT((turned(placed.head<2>(), phi[0]) - C).norm(), 1e-9);
  // Without backlash the tooth fills the space on the pitch circles.
  const double s_1 = phi[0] * pair.mesh.rack.sides[0].pitch_radius;
  const double s_2 = phi[1] * pair.mesh.rack.sides[1].pitch_radius;
  EXPECT_NEAR(s_2 - s_1, pair.mesh.backlash.circumferential[0] / 2, 1e-9);
}

constexpr double kRadian = std::numbers::pi / 180.0;

// The distance, mm, of a point of the housing from the leading flank of the gear's nearest tooth,
// after gear 1 has turned by t pitches from the drawn position.
double beside_flank(const InvolutePair& pair, std::size_t i, double t, const Vec2& point) {
  const Gear& gear = pair.gears[i];
  const Eigen::Isometry3d pose = i == 0 ? pair.pose_1().isometry() : pair.pose_2().isometry();
  const Vec2 arm = point - pose.translation().head<2>();
  // A positive angle of the picture is clockwise.
  const double turned = rotation_to_pitch_point(pair)[i] - kRadian * turn_per_pitch(pair, i) * t;
  const double drawn = std::atan2(pose.linear()(1, 0), pose.linear()(0, 0)) + turned;
  const Arc* flank = gear.tooth->outline.find(ArcName::flank);
  const bool ring = gear.internal();
  const double xi = ring ? flank->curve->parameter_at_radius(arm.norm(), flank->end, flank->begin)
                         : flank->curve->parameter_at_radius(arm.norm(), flank->begin, flank->end);
  // Gear 1 drives with its clockwise flanks. They touch the clockwise flanks of gear 2, because it
  // turns in the opposite direction. An internal gear turns in the same direction, so contact is on
  // its counter-clockwise flanks.
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
}

TEST(Turning, DotsForEveryToothThatPasses) {
  const auto dots = [](const InvolutePair& pair) {
    const MeshScene scene = mesh_scene(pair, {"gear1", "gear2"});
    const std::string text =
        figure_svg(mesh_figure(scene, mesh_window(scene, MeshFrame::mesh, 1.0)));
    std::size_t n = 0;
    for (std::size_t at = text.find("data-tooth"); at != text.npos;
         at = text.find("data-tooth", at + 1))
      ++n;
    return n;
  };
  // The path extends from −0.63 to 0.82 of a pitch, or from −0.11 to 0.58. There is no path if the
  // flanks do not meet.
  EXPECT_EQ(dots(testing::helical_pair()), 2u);
  EXPECT_EQ(dots(testing::two_and_sixty()), 2u);
  EXPECT_EQ(dots(testing::sample_pair(testing::sample_gear(20, 2, 0, 0),
                                      testing::sample_gear(40, 2, 0, 0), 70)),
            0u);
}

TEST(MeshFigure, WindowsHoldWhatTheyShow) {
  for (const InvolutePair& pair : {testing::helical_pair(), testing::pinion_in_cut_ring()}) {
    const MeshScene scene = mesh_scene(pair, {"gear1", "gear2"});
    for (const double aspect : {0.6, 1.0, 2.5}) {
      for (const MeshFrame frame : {MeshFrame::whole, MeshFrame::mesh, MeshFrame::flank}) {
        const Bounds window = mesh_window(scene, frame, aspect);
        EXPECT_NEAR(window.size().x() / window.size().y(), aspect, 1e-12);
        for (const double rho1 : {pair.mesh.rho1_A, pair.mesh.rho1_E}) {
          const Vec2 p = pair.on_line_of_action(rho1).r.head<2>();
          EXPECT_TRUE((p - window.lo).minCoeff() > 0 && (window.hi - p).minCoeff() > 0);
        }
      }
    }
  }
}

TEST(MeshFigure, NamesCirclesInEveryWindow) {
  // A window of a tenth of a module on the tip circle of gear 1, 35° above the centre line.
  const InvolutePair pair = testing::helical_pair();
  const MeshScene scene = mesh_scene(pair, {"gear1", "gear2"});
  const double r = pair.gears[0].actual_tip_radius();
  const Vec2 middle = r * Vec2(std::cos(0.6), std::sin(0.6));
  const std::string text =
      figure_svg(mesh_figure(scene, {middle - Vec2(0.1, 0.1), middle + Vec2(0.1, 0.1)}));
  EXPECT_NE(text.find("circle-name g1"), text.npos);
  EXPECT_EQ(text.find("circle-name g2"), text.npos);
}

}  // namespace
}  // namespace gearwright
