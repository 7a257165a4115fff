// Tests the laws of the outline of the teeth of a rack.
//
// (1) The arcs lead from the middle of the space to the middle of the tooth, and each arc begins at
//     the end of the preceding one.
// (2) The thickness at the datum line is s_n, the addendum is h_a and the dedendum is h_f. In the
//     normal section, the fillet is a circle that is tangent to the land and to the flank.
// (3) If the rack rolls along the pinion, it envelops the flank of the pinion: at every rotation,
//     some flank of the rack touches the pinion, and no point of the pinion is inside the rack.
#include "gearwright/pair/rack_pair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "gearwright/base/testing/taken.hpp"

namespace gearwright {
namespace {

RackPair rack_of(int teeth, double m, double x, double beta, const RackBar& bar = {.teeth = 9}) {
  Gear pinion = testing::taken(make_gear({.teeth = teeth,
                                          .normal_module = m,
                                          .helix_angle = Angle::degrees(beta),
                                          .profile_shift = x,
                                          .face_width = 10 * m}));
  return testing::taken(mount_rack(std::move(pinion), bar));
}

// Half of the width of the rack tooth at a height above the datum line, mm in the transverse
// section, without the fillet. It is computed from s_n and α_n only.
double half_width(const RackPair& p, double height) {
  const double n =
      p.rack.thickness / 2 - height * std::tan(p.pinion.spec.normal_pressure_angle.rad());
  return n / std::cos(p.pinion.spec.helix_angle.rad());
}

TEST(RackOutline, its_arcs_form_half_a_tooth) {
  for (const auto& [m, beta, allowance] :
       {std::tuple{2.0, 0.0, 0.0}, std::tuple{2.0, 23.0, -0.05}, std::tuple{0.5, -40.0, 0.02}}) {
    const RackPair p = rack_of(17, m, 0.1, beta, {.teeth = 9, .thickness_allowance = allowance});
    const Outline o = testing::taken(rack_outline(p.rack));
    EXPECT_EQ(o.teeth, 9);
    // (1)
    EXPECT_EQ(o.arcs.front().begin_point, Vec2(-1.25 * m, p.rack.transverse_pitch / 2));
    EXPECT_EQ(o.arcs.back().end_point, Vec2(m, 0.0));
    for (std::size_t i = 1; i < o.arcs.size(); ++i)
      EXPECT_EQ(o.arcs[i].begin_point, o.arcs[i - 1].end_point);
    // (2)
    const Arc& flank = *o.find(ArcName::flank);
    const double u = -flank.begin_point.x() / (flank.end_point.x() - flank.begin_point.x());
    const double y = flank.point(u).y();
    EXPECT_NEAR(2 * y * std::cos(beta * std::numbers::pi / 180),
                std::numbers::pi * m / 2 + allowance, 1e-14 * m);
    const Arc& fillet = *o.find(ArcName::root_fillet);
    const double rho = p.rack.fillet_radius, k = 1 / std::cos(p.rack.helix_angle.rad());
    EXPECT_NEAR(rho, 0.38 * m, 0.003 * m);
    const Vec2 center(rho - 1.25 * m, fillet.begin_point.y());
    for (double v = 0.0; v <= 1.0; v += 0.125) {
      const Vec2 d = fillet.point(v) - center;
      EXPECT_NEAR(std::hypot(d.x(), d.y() / k), rho, 1e-14 * m);
    }
    EXPECT_NEAR(std::remainder(fillet.at(1.0).tangent_angle - flank.at(0.0).tangent_angle,
                               2 * std::numbers::pi),
                0.0, 1e-14);
    EXPECT_NEAR(std::cos(fillet.at(0.0).tangent_angle), 0.0, 1e-14);
  }
}

TEST(RackOutline, a_full_radius_leaves_no_land) {
  // Half of the space at the root is (2π − π − 0.4)/2 − 2.5 tan 20° = 0.4609 mm wide. The greatest
  // radius that fits is 0.4609 cos 20°/(1 − sin 20°) = 0.6582 mm.
  const RackPair p = rack_of(20, 2, 0, 0, {.teeth = 3, .thickness_allowance = 0.4});
  const Outline o = testing::taken(rack_outline(p.rack));
  EXPECT_EQ(o.find(ArcName::root_land), nullptr);
  EXPECT_NEAR(p.rack.fillet_radius, 0.6582, 1e-4);
  EXPECT_EQ(o.arcs.front().begin_point, Vec2(-2.5, std::numbers::pi));
}

TEST(RackOutline, an_allowance_that_leaves_no_tooth_is_rejected) {
  for (const double allowance : {-2.0, 1.5}) {
    RackGeometry rack = rack_of(20, 2, 0, 0, {.teeth = 3}).rack;
    rack.bar.thickness_allowance = allowance;
    const auto outline = rack_outline(rack);
    ASSERT_FALSE(outline);
    EXPECT_EQ(outline.error().field, "gear2.thickness_allowance");
    const auto pair = mount_rack(rack_of(20, 2, 0, 0).pinion, {.thickness_allowance = allowance});
    ASSERT_FALSE(pair);
    EXPECT_EQ(pair.error().field, "gear2.thickness_allowance");
  }
}

// (3) The test measures points of the whole outline of the pinion against the straight flanks,
//     which follow from pitch, thickness and angle of the rack only.
TEST(RackOutline, rolling_envelops_the_flank_of_the_pinion) {
  for (const auto& [teeth, x, beta] :
       {std::tuple{20, 0.0, 0.0}, std::tuple{17, 0.3, 0.0}, std::tuple{24, 0.1, 20.0}}) {
    const RackPair p = rack_of(teeth, 2, x, beta);
    const double p_t = p.rack.transverse_pitch, r = p.pinion.reference_diameter / 2;
    const double cosine = std::cos(p.pinion.reference().transverse_pressure_angle);
    for (int step = 0; step < 12; ++step) {
      const double phi = 2 * std::numbers::pi / teeth * step / 12;
      double least = 1.0;
      for (int k = -3; k <= 3; ++k) {
        for (const Arc& arc : p.pinion.tooth->outline.arcs) {
          for (const int side : {+1, -1}) {
            for (int i = 0; i <= 4000; ++i) {
              const Vec2 w = arc.point(i / 4000.0);
              const double turn = phi + 2 * std::numbers::pi * k / teeth;
              const double X = w.x() * std::cos(turn) - side * w.y() * std::sin(turn);
              const double Y = w.x() * std::sin(turn) + side * w.y() * std::cos(turn);
              // In the frame of the rack, which has moved by r φ, a space lies on the centre line.
              const double height = p.center_distance - X;
              if (height > p.rack.addendum) continue;
              const double from_space = std::remainder(Y - r * phi, p_t);
              const double from_tooth = p_t / 2 - std::abs(from_space);
              const double gap = (from_tooth - half_width(p, height)) * cosine;
              least = std::min(least, gap);
            }
          }
        }
      }
      // The radius of curvature of the involute at the contact is at least 1 mm, so points that are
      // 1e-3 mm apart miss the contact by less than 1e-6 mm.
      EXPECT_GT(least, -1e-11) << step;
      EXPECT_LT(least, 1e-6) << step;
    }
  }
}

}  // namespace
}  // namespace gearwright
