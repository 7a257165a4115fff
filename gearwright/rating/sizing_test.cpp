// The least sufficient face width is compared with smaller widths.
#include "gearwright/rating/sizing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/testing/draw.hpp"
#include "gearwright/rating/testing/sample_pairs.hpp"

namespace gearwright {
namespace {

// (1) the width is sufficient
// (2) no smaller width is sufficient, as tested for many widths
// (3) a slightly smaller width is insufficient, so one safety factor equals the required value,
//     unless it jumps there
// The required safety factors are slightly less than those of a known width, so the result is not
// wider than this width.
TEST(Sizing, FaceWidthOfSafetyIsTheLeast) {
  testing::Draw random(20261123);
  int answers = 0, gaps = 0;
  for (int i = 0; i < 300; ++i) {
    const double m = random.uniform(1, 6);
    const double beta = i % 2 == 0 ? 0.0 : random.uniform(5, 25);
    const RatedPair pair =
        testing::printed_pair({random.whole(17, 40), random.uniform(0, 0.4), 0},
                              {random.whole(41, 90), random.uniform(-0.1, 0.3), 0}, m, beta, 10 * m,
                              0, *iso53_rack("ISO53-A"));
    RatingInput in = testing::helical_24_95_load();
    in.edition = i % 3 == 0 ? RatingEdition::iso_2019 : RatingEdition::iso_2006;
    in.torque = random.uniform(0.5, 20) * m * m * m;
    in.speed = random.uniform(100, 3000);
    in.quality = {random.whole(5, 9), random.whole(5, 9)};
    in.body.reset();
    if (i % 4 == 1) {
      in.face_load_factor.reset();
      PinionMounting mounting;
      mounting.bearing_span = 100 * m;
      mounting.offset = 10 * m;
      mounting.shaft_diameter = 12 * m;
      in.mounting = mounting;
    }
    const double there = random.uniform(3, 35) * m;
    const auto rated = rate(with_face_width(pair, there), in);
    if (!rated) continue;
    constexpr double kLittle = 0.998;
    const Safeties wanted{kLittle * std::min(rated->S_H[0].value, rated->S_H[1].value),
                          kLittle * std::min(rated->S_F[0].value, rated->S_F[1].value)};
    const auto holds_at = [&](double b) {
      const auto r = rate(with_face_width(pair, b), in);
      return r && holds(*r, wanted);
    };
    ASSERT_TRUE(holds_at(there));
    const auto b = face_width_of_safety(pair, in, wanted, kMostFaceModules * m);
    ASSERT_TRUE(b) << i;
    EXPECT_TRUE(holds_at(*b)) << i;          // (1)
    EXPECT_LE(*b, there * (1 + 1e-6)) << i;  // (2)
    gaps += *b < there * 0.99;
    if (*b == m) continue;
    EXPECT_FALSE(holds_at(*b * (1 - 2e-7))) << i;  // (3)
    int below = 0;
    for (int n = 0; n < 400; ++n) below += holds_at(*b - (*b - m) * (n + 0.5) / 400 - 1e-4 * *b);
    EXPECT_EQ(below, 0) << i;  // (2)
    ++answers;
  }
  EXPECT_GE(answers, 250);
  EXPECT_GE(gaps, 5);  // sufficient widths below a gap of insufficient ones
}

// A spectrum of one step has the torque and the face width of a single load with the life of this
// step. They are not those of a load without life, whose life factors are 1.
TEST(Sizing, SpectrumOfOneStepIsThePlainRating) {
  const RatedPair pair = testing::helical_24_95();
  RatingInput in = testing::helical_24_95_load();
  in.application_factor = 1.0;
  in.torque *= 2;
  const Safeties wanted{1.25, 1.5};
  for (const double hours : {10.0, 500.0, 20000.0, 1e6}) {
    const std::vector<LoadBin> step{{in.torque, *in.speed, hours}};
    RatingInput plain = in;
    plain.life_h = hours;
    const double torque = torque_of_safety(pair, plain, wanted).value();
    const double width = face_width_of_safety(pair, plain, wanted, 5000).value();
    in.life_h.reset();
    EXPECT_NEAR(torque_of_safety(pair, in, wanted, step).value(), torque, 1e-8 * torque) << hours;
    EXPECT_NEAR(face_width_of_safety(pair, in, wanted, 5000, step).value(), width, 1e-6 * width)
        << hours;
    EXPECT_GT(std::abs(torque_of_safety(pair, in, wanted).value() / torque - 1), 1e-3) << hours;
  }
}

// The greatest torque is that of the greatest step, and all torques are multiplied by one factor.
TEST(Sizing, TorqueOfASpectrumScalesAllSteps) {
  const RatedPair pair = testing::helical_24_95();
  RatingInput in = testing::helical_24_95_load();
  in.life_h.reset();
  const Safeties wanted{1.2, 1.5};
  std::vector<LoadBin> steps{{40000, *in.speed, 5000}, {60000, *in.speed, 300}};
  const double torque = torque_of_safety(pair, in, wanted, steps).value();
  const auto least = [&](double factor) {
    std::vector<LoadBin> scaled = steps;
    for (LoadBin& step : scaled) step.torque *= factor * torque / 60000;
    const SpectrumRating s = rate_spectrum(pair, in, scaled).value();
    return std::min(std::min(s.S_H[0], s.S_H[1]) / wanted.flank,
                    std::min(s.S_F[0], s.S_F[1]) / wanted.root);
  };
  EXPECT_GE(least(1 - 1e-8), 1.0);
  EXPECT_LT(least(1 + 1e-7), 1.0);
}

}  // namespace
}  // namespace gearwright
