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

}  // namespace
}  // namespace gearwright
