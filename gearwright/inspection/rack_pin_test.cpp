// Tests the laws of a measuring pin on a rack with the outline of its teeth.
//
// (1) The outline of half a space, sampled in the normal section, has the least distance D_M/2 from
//     the axis of the pin. The space is symmetric, so the pin touches both flanks and nothing else.
// (2) A thickness allowance E_sn changes the dimension by E_sn/(2 tan α_n).
// (3) The dimension over a ball in a wheel of z teeth approaches the dimension over the pin like
//     1/z.
#include "gearwright/inspection/rack_pin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/inspection/balls.hpp"

namespace gearwright {
namespace {

using testing::taken;

RackGeometry rack_of(double m, double beta, double allowance) {
  Gear pinion = taken(make_gear({.teeth = 20,
                                 .normal_module = m,
                                 .helix_angle = Angle::degrees(beta),
                                 .face_width = 10 * m}));
  return taken(mount_rack(std::move(pinion), {.teeth = 9, .thickness_allowance = allowance})).rack;
}

// The least distance of the half outline from the axis of the pin, which lies in the middle of the
// space, in the normal section.
double least_distance(const RackGeometry& rack, const RackPin& pin) {
  const Outline half = taken(rack_outline(rack));
  const double cosine = std::cos(rack.helix_angle.rad());
  double least = 1e9;
  for (const Arc& arc : half.arcs)
    for (int i = 0; i <= 20'000; ++i) {
      const Vec2 p = arc.point(i / 20'000.0);
      least =
          std::min(least, std::hypot(p.x() - pin.height, p.y() * cosine - rack.normal_pitch / 2));
    }
  return least;
}

TEST(RackPin, touches_both_flanks_and_nothing_else) {
  for (const auto& [m, beta, allowance] :
       {std::tuple{2.0, 0.0, 0.0}, std::tuple{2.0, 25.0, -0.05}, std::tuple{0.5, -40.0, 0.02},
        std::tuple{6.0, 12.0, -0.3}}) {
    const RackGeometry rack = rack_of(m, beta, allowance);
    const auto pin = usual_pin(rack);
    ASSERT_TRUE(pin.has_value());
    EXPECT_NEAR(least_distance(rack, *pin), pin->diameter / 2, 1e-8 * m);  // (1)
    EXPECT_GE(least_distance(rack, *pin), pin->diameter / 2 - 1e-13 * m);
    EXPECT_GT(pin->height + pin->diameter / 2, rack.addendum);
    EXPECT_NEAR(pin->dimension, rack.height + pin->height + pin->diameter / 2, 1e-13);
    // No size of DIN 3977 for a module up to 25 mm differs by more than a sixth from the ideal
    // size, whose contacts are at the datum line.
    EXPECT_LT(std::abs(pin->contact), 0.5 * m);
  }
}

TEST(RackPin, an_allowance_changes_the_dimension) {
  const RackGeometry full = rack_of(2, 0, 0), thin = rack_of(2, 0, -0.1);
  const double more = pin_on_rack(thin, 3.5)->dimension - pin_on_rack(full, 3.5)->dimension;
  EXPECT_NEAR(more, -0.1 / (2 * std::tan(std::numbers::pi / 9)), 1e-13);  // (2)
}

TEST(RackPin, is_the_limit_of_balls_in_wheels) {
  for (const double beta : {0.0, 18.0}) {
    const RackGeometry rack = rack_of(2, beta, -0.04);
    const double over = pin_on_rack(rack, 3.5)->dimension - rack.height;
    const auto difference = [&](int teeth) {
      const Gear wheel = taken(make_gear({.teeth = teeth,
                                          .normal_module = 2,
                                          .helix_angle = Angle::degrees(beta),
                                          .thickness_allowance = -0.04,
                                          .face_width = 20}));
      return taken(ball_in_space(wheel, 3.5)).radial - wheel.reference_diameter / 2 - over;
    };
    const double some = difference(1'000), more = difference(10'000);
    EXPECT_LT(std::abs(some), 5e-3);
    EXPECT_NEAR(more, some / 10, 0.01 * std::abs(some));  // (3)
  }
}

// For D_M = e_n/cos α_n, the contacts are at the datum line.
TEST(RackPin, that_cannot_be_measured_is_none) {
  const RackGeometry rack = rack_of(2, 0, 0);
  EXPECT_NEAR(pin_on_rack(rack, std::numbers::pi / std::cos(std::numbers::pi / 9))->contact, 0.0,
              1e-14);
  EXPECT_FALSE(pin_on_rack(rack, 1.0));        // rests on the root
  EXPECT_FALSE(pin_on_rack(rack, 2.9));        // ends below the tips
  EXPECT_FALSE(pin_on_rack(rack, 10.0));       // rests on the tips
  EXPECT_FALSE(usual_pin(rack_of(50, 0, 0)));  // greater than every size
}

// A pin of 1.728 modules can be measured. A pin of 1.5 mm rests on the root.
TEST(RackPin, has_the_given_diameter_if_it_can_be_measured) {
  RackGeometry rack = rack_of(2, 0, 0);
  const double standard = usual_pin(rack)->diameter;
  rack.bar.pin_diameter = 1.728 * 2;
  EXPECT_EQ(usual_pin(rack)->diameter, 1.728 * 2);
  rack.bar.pin_diameter = 1.5;
  EXPECT_EQ(usual_pin(rack)->diameter, standard);
}

}  // namespace
}  // namespace gearwright
