// Load spectra: a spectrum of one step equals the rating for one load, and splitting and adding
// steps have only the permitted effect.
#include "gearwright/rating/spectrum.hpp"

#include <gtest/gtest.h>

#include "gearwright/rating/sizing.hpp"
#include "gearwright/rating/testing/sample_pairs.hpp"

namespace gearwright {
namespace {

RatingInput steady_load() {
  RatingInput in = testing::helical_24_95_load();
  in.application_factor = 1.0;
  return in;
}

// Law (1), for flanks and roots, in the range of limited life and beyond this range.
TEST(Spectrum, OneStepIsThePlainRating) {
  const RatedPair pair = testing::helical_24_95();
  for (const double hours : {0.1, 10.0, 500.0, 20000.0}) {
    RatingInput in = steady_load();
    in.life_h = hours;
    const Rating plain = rate(pair, in).value();
    const SpectrumRating s = rate_spectrum(pair, in, {{in.torque, *in.speed, hours}}).value();
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_NEAR(s.S_H[i], plain.S_H[i].value, 1e-6);
      EXPECT_NEAR(s.S_F[i], plain.S_F[i].value, 1e-6);
    }
  }
}

// Law (2). In addition, a greater load causes more damage.
TEST(Spectrum, StepsAddUp) {
  const RatedPair pair = testing::helical_24_95();
  const RatingInput in = steady_load();
  const double n = *in.speed;
  const SpectrumRating whole = rate_spectrum(pair, in, {{130000, n, 200}}).value();
  const SpectrumRating cut =
      rate_spectrum(pair, in, {{130000, n, 50}, {130000, n, 150}, {1000, n, 1e5}}).value();
  const SpectrumRating more = rate_spectrum(pair, in, {{130000, n, 200}, {140000, n, 20}}).value();
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(cut.S_H[i], whole.S_H[i], 1e-9);
    EXPECT_NEAR(cut.damage_flank[i], whole.damage_flank[i], 1e-9);
    EXPECT_LT(more.S_H[i], whole.S_H[i]);
    EXPECT_EQ(whole.damage_flank[i] <= 1.0, whole.S_H[i] >= 1.0);
  }
}

TEST(Sizing, TorqueOfSafetyHasIt) {
  const RatedPair pair = testing::helical_24_95();
  RatingInput in = testing::helical_24_95_load();
  const Safeties wanted{1.2, 1.5};
  in.torque = *torque_of_safety(pair, in, wanted);
  const Rating r = rate(pair, in).value();
  EXPECT_TRUE(holds(r, wanted));
  in.torque *= 1 + 1e-8;
  EXPECT_FALSE(holds(rate(pair, in).value(), wanted));
}

TEST(Sizing, FaceWidthOfSafetyHasIt) {
  const RatedPair pair = testing::helical_24_95();
  RatingInput in = testing::helical_24_95_load();
  in.torque *= 2.5;
  const Safeties wanted{1.25, 1.5};
  EXPECT_FALSE(holds(rate(pair, in).value(), wanted));
  const auto b = face_width_of_safety(pair, in, wanted, 2000);
  ASSERT_TRUE(b.has_value());
  EXPECT_TRUE(holds(rate(with_face_width(pair, *b), in).value(), wanted));
  in.torque *= 1000;
  EXPECT_FALSE(face_width_of_safety(pair, in, wanted, 2000).has_value());
}

TEST(Sizing, SteelOfSafetyHasIt) {
  const RatedPair pair = testing::helical_24_95();
  RatingInput in = testing::helical_24_95_load();
  in.materials = {*material_named("42CrMo4"), *material_named("42CrMo4")};
  const Safeties wanted{1.25, 1.5};
  const auto steel = steel_of_safety(pair, in, wanted);
  ASSERT_TRUE(steel.has_value());
  in.materials = {*material_named(*steel), *material_named(*steel)};
  EXPECT_TRUE(holds(rate(pair, in).value(), wanted));
}

}  // namespace
}  // namespace gearwright
