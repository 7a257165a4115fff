// Compares dimensions over two and three pins between anvils with the distances of lines and planes
// that touch circles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "gearwright/arrange/measured_gear.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/base/testing/taken.hpp"
#include "gearwright/base/vector.hpp"
#include "gearwright/gear/testing/made.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/inspection/balls.hpp"

namespace gearwright {
namespace {

Gear helical(int teeth, double module, double beta_deg, double x) {
  return testing::made(testing::plain_spec(
      {.teeth = teeth, .module = module, .beta_deg = beta_deg, .x = x, .face_width = 20.0}));
}
Gear spur(int teeth, double module, double x) { return helical(teeth, module, 0.0, x); }

// The standard size nearest to the ideal size, 3.5 mm, does not project beyond the tip. The next
// size that can be measured is 3.75 mm.
TEST(BallSizes, TheStandardSizeCanBeMeasured) {
  auto spec = testing::plain_spec({.teeth = 30, .module = 2.0, .face_width = 20.0});
  spec.tip_diameter = 65.0;
  const Gear gear = testing::made(spec);
  const auto sizes = ball_sizes(gear);
  ASSERT_TRUE(sizes);
  EXPECT_NEAR(sizes->ideal, 3.41134, 1e-5);
  EXPECT_EQ(sizes->metric, 3.75);
  EXPECT_FALSE(ball_in_space(gear, 3.5));
  EXPECT_TRUE(ball_in_space(gear, 3.75));
}

// Width between two parallel lines over circles with these centres; the normal of the lines has the
// angle θ.
double width_over(const std::vector<Vec2>& centers, double radius, double theta) {
  double far = -1e300, near = 1e300;
  for (const Vec2& c : centers) {
    const double at = c.x() * std::cos(theta) + c.y() * std::sin(theta);
    far = std::max(far, at + radius);
    near = std::min(near, at - radius);
  }
  return far - near;
}

// In the transverse section of a spur gear, pins are circles in the spaces, and anvils are lines
// that turn around the circles. A micrometer over two pins reads the greatest width. A micrometer
// over three pins comes to rest at the least width.
TEST(Pins, three_of_them_lie_deeper_on_a_spur_gear_with_an_odd_number_of_teeth) {
  int odd = 0;
  for (const int z : {5, 7, 8, 17, 20, 33, 61, 100}) {
    const Gear gear = spur(z, 2, 0.2);
    const auto seat = ball_in_space(gear, ball_sizes(gear)->ideal);
    ASSERT_TRUE(seat) << z;
    const double r_K = seat->center_diameter / 2, pitch = 2 * kPi / z;
    const auto in_space = [&](int k) {
      return Vec2(r_K * std::cos(k * pitch), r_K * std::sin(k * pitch));
    };
    const PinReading pins = over_pins(gear, *seat);
    const std::vector<Vec2> two{in_space(0), in_space(z / 2)};
    std::vector<Vec2> three = two;
    if (z % 2 == 1) three.push_back(in_space(z / 2 + 1));
    double greatest = 0, least = 1e300;
    for (int i = -20000; i <= 20000;
         ++i) {  // up to a quarter of a pitch to both sides of the line of centres
      const double theta = 1e-4 * i * pitch / 4;
      greatest = std::max(greatest, width_over(two, seat->ball_diameter / 2, theta));
      least = std::min(least, width_over(three, seat->ball_diameter / 2, theta));
    }
    EXPECT_NEAR(*pins.three, greatest, 1e-7 * r_K) << z;
    EXPECT_EQ(*pins.three, over_two_balls(gear, *seat)) << z;
    if (z % 2 == 1) {
      EXPECT_NEAR(*pins.three_pins, least, 1e-12 * r_K) << z;
      EXPECT_LT(*pins.three_pins, *pins.three) << z;
    } else {
      EXPECT_EQ(*pins.three_pins, *pins.three) << z;
    }
    odd += z % 2;
  }
  EXPECT_GE(odd, 4);
}

// A straight pin in a helical space is tangent to the helix of the space. A plane over the pin
// touches an end of the pin, unless pin and plane are parallel. In this case the plane is lowest,
// so the pins move to this position when the micrometer is closed.
TEST(Pins, three_of_them_read_the_outermost_places_of_a_helical_gear) {
  for (const int z : {17, 20, 95}) {
    const Gear gear = helical(z, 3, 12, 0.3);
    const auto seat = testing::taken(ball_in_space(gear, ball_sizes(gear)->ideal));
    const PinReading pins = over_pins(gear, seat);
    const double r_K = seat.center_diameter / 2, r = seat.ball_diameter / 2, half = 20.0;
    const double beta_K = std::atan(2 * r_K / gear.reference().base_diameter *
                                    std::tan(gear.reference().base_helix_angle));
    double lowest = 1e300;
    for (int i = -2000; i <= 2000; ++i) {
      const double phi = 1e-5 * i;
      const double lean =
          std::abs(std::sin(phi) * std::sin(beta_K));  // inclination of the pin to the plane
      lowest = std::min(lowest, r_K * std::cos(phi) + half * lean + r * std::sqrt(1 - lean * lean));
    }
    EXPECT_NEAR(*pins.three_pins, 2 * lowest, 1e-12 * r_K);
    EXPECT_EQ(*pins.three_pins, *pins.three);
  }
  // In rings, the spaces of spur gears are measured with the anvils inside, and a straight pin does
  // not fit into a helical space.
  const Gear ring = spur(-61, 2, 0);
  const auto seat = testing::taken(ball_in_space(ring, ball_sizes(ring)->ideal));
  const double c = std::cos(kPi / 61);
  EXPECT_NEAR(*over_pins(ring, seat).three_pins,
              seat.center_diameter / 2 * (1 + c) - seat.ball_diameter,
              1e-12 * ring.reference_diameter);
  const Gear slanted = helical(-61, 2, 15, 0);
  const auto ball = ball_in_space(slanted, ball_sizes(slanted)->ideal);
  EXPECT_FALSE(over_pins(slanted, testing::taken(ball)).three_pins);
}

// z 13, m 6, β 45°, x 0.3: the least dimension is 122.02 mm, with contacts more than 62 mm apart
// along the axis. On a face of 60 mm, this position does not exist.
TEST(Pins, that_may_tilt_have_a_note_on_a_face_that_is_too_narrow) {
  CylindricalSpec spec =
      testing::plain_spec({.teeth = 13, .module = 6, .beta_deg = 45, .x = 0.3, .face_width = 60.0});
  spec.thickness_allowance = -0.15;
  std::vector<Warning> notes;
  Arranged alone{GivenPair()};
  alone.completed.gears[0].emplace();
  alone.gears.push_back(testing::made(spec));
  const auto measures = testing::taken(measure(alone, {}, notes));
  ASSERT_TRUE(measures.pins);
  EXPECT_NEAR(*measures.pins->reading.two_free, 122.0217, 1e-4);
  EXPECT_GT(*measures.pins->reading.two_free_face, 62.0);
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(),
                          [](const Warning& w) { return w.code == WarningCode::pin_off_flank; }));
  spec.face_width = 80.0;
  notes.clear();
  alone.gears = {testing::made(spec)};
  EXPECT_TRUE(measure(alone, {}, notes));
  EXPECT_TRUE(std::none_of(notes.begin(), notes.end(),
                           [](const Warning& w) { return w.code == WarningCode::pin_off_flank; }));
}

// z 40, m 3, β 25°, b 20.3 mm: over 6 teeth, W_k sin β_b is 20.2272 mm, so the anvils rest on 0.07
// mm of the face. With b_M = 1.2 mm + 0.018 W_k, a span over 6 teeth requires a face of 22.17 mm,
// and a span over 5 teeth requires 18.51 mm.
TEST(Span, notes_a_face_on_which_the_anvils_would_tip_off) {
  const auto notes_at = [](double face_width) {
    Arranged alone{GivenPair()};
    alone.completed.gears[0].emplace();
    alone.gears.push_back(testing::made(
        testing::plain_spec({.teeth = 40, .module = 3, .beta_deg = 25, .face_width = face_width})));
    std::vector<Warning> notes;
    EXPECT_EQ(testing::taken(measure(alone, {}, notes)).span->teeth, 6);
    std::string text;
    for (const Warning& w : notes)
      if (w.code == WarningCode::span_off_face) text += w.message;
    return text;
  };
  EXPECT_EQ(notes_at(20.3),
            "In a span over 6 teeth, the contacts overlap the face by only 0.073 mm. Measuring "
            "practice requires a face width of 22.17 mm, but the face width is 20.3 mm. For a "
            "span over 5 teeth, a face width of 18.51 mm is sufficient.");
  EXPECT_EQ(notes_at(22.2), "");
}

// The oracle tries every ball in steps of 2 µm and shares no code with the search for the limits.
TEST(Balls, of_the_sizes_in_a_message_can_be_measured) {
  for (const Gear& gear : {spur(12, 10, 0.5), spur(16, 3, 0), helical(23, 2.5, 18, 0.4),
                           spur(-60, 2, 0), helical(-45, 3, 12, 0.2)}) {
    const double m = gear.spec.normal_module;
    const auto fits = [&](double ball) {
      const auto seat = ball_in_space(gear, ball);
      return seat && seat->usable();
    };
    double least = 0.0, most = 0.0;
    for (double ball = 0.5 * m; ball < 8 * m; ball += 0.002) {
      if (!fits(ball)) continue;
      if (least == 0.0) least = ball;
      most = ball;
    }
    const auto refused = ball_in_space(gear, 0.5 * m);
    ASSERT_FALSE(refused);
    const std::string text = refused.error().message();
    double low = 0.0, high = 0.0;
    const std::size_t at = text.find("balls of ");
    ASSERT_NE(at, std::string::npos) << text;
    ASSERT_EQ(std::sscanf(text.c_str() + at, "balls of %lf mm to %lf mm", &low, &high), 2) << text;
    EXPECT_NEAR(low, least, 0.0021) << text;
    EXPECT_NEAR(high, most, 0.0021) << text;
    EXPECT_TRUE(fits(low) && fits(high)) << text;
  }
}

}  // namespace
}  // namespace gearwright
