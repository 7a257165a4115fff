// Plastics to VDI 2736, compared with a calculation by hand for a spur pair of module 1. Laws: (1)
// a doubled torque doubles σ_F and the temperature rise; (2) exchanging the gears does not change
// the numbers; (3) strength decreases with temperature.
#include "gearwright/rating/plastic.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/base/numbers.hpp"
#include "gearwright/rating/rating.hpp"
#include "gearwright/rating/testing/sample_pairs.hpp"

namespace gearwright {
namespace {

Material pom() {
  Material m;
  m.name = "a POM";
  m.kind = MaterialKind::plastic;
  m.poisson_ratio = 0.35;
  m.youngs_modulus = 2800;
  m.youngs_modulus_by = {{20, 2800}, {60, 1800}, {100, 1000}};
  m.sigma_Hlim_by = {{20, 60}, {100, 30}};
  m.sigma_Flim_by = {{20, 40}, {60, 28}, {100, 16}};
  return m;
}

RatedPair pair_17_39() {
  return testing::printed_pair({17, 0.2, 0}, {39, 0.1, 0}, 1.0, 0, 6.0, 0, *iso53_rack("ISO53-A"));
}

RatingInput load(double torque = 0.2) {
  RatingInput in;
  in.edition = RatingEdition::vdi_2736;
  in.torque = torque;
  in.speed = 1500;
  in.application_factor = 1.25;
  in.plastic.ambient_temperature = 23.0;
  in.plastic.friction = 0.2;
  in.materials = {testing::case_hardened(), pom()};
  return in;
}

TEST(Plastic, ValuesBetweenTemperatures) {
  const ByTemperature list{{20, 40}, {60, 28}, {100, 16}};
  EXPECT_EQ(at_temperature(list, 20), 40);
  EXPECT_EQ(at_temperature(list, 40), 34);
  EXPECT_EQ(at_temperature(list, 60), 28);
  EXPECT_EQ(at_temperature(list, 80), 22);
  EXPECT_EQ(at_temperature(list, 100), 16);
  EXPECT_FALSE(at_temperature(list, 19.99));
  EXPECT_FALSE(at_temperature(list, 100.01));
  EXPECT_FALSE(at_temperature({}, 20));
}

TEST(Plastic, TemperaturesByHand) {
  const RatedPair pair = pair_17_39();
  // Partial contact ratios from the tip circles, and the tooth loss factor according to Ohlendorf.
  std::array<double, 2> part{};
  for (const std::size_t i : {0, 1}) {
    const RatedGear& g = pair.gears[i];
    const double r_a = g.tip_diameter / 2;
    const double r_b = g.base_diameter / 2;
    part[i] = (std::sqrt(r_a * r_a - r_b * r_b) - r_b * std::tan(pair.alpha_wt)) /
              (kPi * g.base_diameter / g.teeth);
  }
  EXPECT_NEAR(part[0] + part[1], pair.epsilon_alpha, 1e-12);
  const double loss =
      kPi * (1.0 / 17 + 1.0 / 39) * (1 - part[0] - part[1] + part[0] * part[0] + part[1] * part[1]);
  EXPECT_NEAR(tooth_loss(pair), loss, 1e-14);
  RatingInput in = load();
  in.plastic.housing_resistance = 0.06;
  in.plastic.housing_area = 0.03;
  in.plastic.duty = 0.5;
  const Rating r = rate(pair, in).value();
  const double power = 0.2 * 1500 * 2 * kPi / 60;
  const double v = kPi * 17 * 1500 / 60000;
  RatingInput two = in;
  two.materials[0] = pom();
  const Rating both = rate(pair, two).value();
  for (const std::size_t i : {0, 1}) {
    const double z = i == 0 ? 17 : 39;
    const auto warm = [&](double k) {
      return 23 + power * 0.2 * loss * (k / (6 * z * std::pow(v * 1.0, 0.75)) + 0.06 / 0.03) *
                      std::pow(0.5, 0.64);
    };
    EXPECT_NEAR(both.temperature->flank[i].value, warm(9000), 1e-10);
    EXPECT_NEAR(both.temperature->root[i].value, warm(2148), 1e-10);
    if (i == 0) continue;  // Young's modulus of steel
    EXPECT_NEAR(r.temperature->flank[i].value, warm(6300), 1e-10);
    EXPECT_NEAR(r.temperature->root[i].value, warm(895), 1e-10);
  }
  EXPECT_FALSE(is_there(r.temperature->flank[0]));
}

TEST(Plastic, StressesByHand) {
  const RatedPair pair = pair_17_39();
  RatingInput in = load();
  in.plastic.flank_temperature = {40, 40};
  in.plastic.root_temperature = {40, 40};
  const Rating r = rate(pair, in).value();
  const double F_t = 2000 * 0.2 / 17;
  EXPECT_NEAR(r.F_t.value, F_t, 1e-12);
  EXPECT_NEAR(r.Y_epsilon->value, 0.25 + 0.75 / pair.epsilon_alpha, 1e-15);
  // The direction and the arm of the load at the tip circle, according to DIN 3990-3, method C.
  for (const std::size_t i : {0, 1}) {
    const RatedGear& g = pair.gears[i];
    const CriticalSection& s = r.section[i];
    EXPECT_NEAR(s.d_en, g.tip_diameter, 1e-12);
    const double alpha_a = std::acos(g.base_diameter / g.tip_diameter);
    const double gamma = (kPi / 2 + 2 * g.profile_shift * std::tan(pair.alpha_n)) / g.teeth +
                         std::tan(pair.alpha_n) - pair.alpha_n - (std::tan(alpha_a) - alpha_a);
    EXPECT_NEAR(s.alpha_Fen, alpha_a - gamma, 1e-12);
    // The point at which the normal of the flank crosses the centre line, and the chord of the
    // section below it.
    const double crossing = g.base_diameter / 2 / std::cos(s.alpha_Fen);
    const auto single = critical_section(pair, g);
    const double single_crossing = g.base_diameter / 2 / std::cos(single->alpha_Fen);
    EXPECT_NEAR(s.h_F - single->h_F, crossing - single_crossing, 1e-12);
    EXPECT_EQ(s.s_Fn, single->s_Fn);
    EXPECT_EQ(s.rho_F, single->rho_F);
    EXPECT_GT(r.Y_F[i].value, 0.0);
    const double sigma =
        1.25 * F_t / (6 * 1.0) * r.Y_F[i].value * r.Y_S[i].value * r.Y_epsilon->value;
    EXPECT_NEAR(r.sigma_F[i].value, sigma, 1e-12 * sigma);
  }
  EXPECT_NEAR(r.sigma_FG[1].value, 2 * 34, 1e-12);
  EXPECT_NEAR(r.S_F[1].value, 68 / r.sigma_F[1].value, 1e-12);
  const double E_2 = 2300;
  const double Z_E = std::sqrt(1 / (kPi * ((1 - 0.3 * 0.3) / 206000 + (1 - 0.35 * 0.35) / E_2)));
  EXPECT_NEAR(r.Z_E.value, Z_E, 1e-12);
  const double sigma_H = r.Z_H.value * Z_E * std::sqrt((4 - pair.epsilon_alpha) / 3) *
                         std::sqrt(1.25 * F_t / (17 * 6.0) * (39.0 / 17 + 1) / (39.0 / 17));
  EXPECT_NEAR(r.sigma_H[0].value, sigma_H, 1e-11);
  EXPECT_NEAR(r.S_H[1].value, 52.5 / sigma_H, 1e-12);
  EXPECT_FALSE(is_there(r.Z_L));
  EXPECT_FALSE(is_there(r.stiffness.c_th));
}

TEST(Plastic, DoubledTorque) {  // (1)
  const RatedPair pair = pair_17_39();
  const Rating one = rate(pair, load(0.1)).value();
  const Rating two = rate(pair, load(0.2)).value();
  for (const std::size_t i : {0, 1}) {
    EXPECT_NEAR(two.sigma_F[i].value, 2 * one.sigma_F[i].value, 1e-12);
  }
  EXPECT_NEAR(two.temperature->root[1].value - 23, 2 * (one.temperature->root[1].value - 23),
              1e-11);
}

TEST(Plastic, GearsExchanged) {  // (2)
  const RatedPair back =
      testing::printed_pair({39, 0.1, 0}, {17, 0.2, 0}, 1.0, 0, 6.0, 0, *iso53_rack("ISO53-A"));
  ASSERT_TRUE(back.exchanged);
  RatingInput in = load(0.2 * 39 / 17);
  in.speed = 1500.0 * 17 / 39;
  in.materials = {pom(), testing::case_hardened()};
  const Rating a = rate(pair_17_39(), load()).value();
  const Rating b = rate(back, in).value();
  for (const std::size_t i : {0, 1}) {
    EXPECT_NEAR(a.S_F[i].value, b.S_F[1 - i].value, 1e-12 * a.S_F[i].value);
    EXPECT_NEAR(a.S_H[i].value, b.S_H[1 - i].value, 1e-12 * a.S_H[i].value);
  }
  EXPECT_NEAR(a.temperature->flank[1].value, b.temperature->flank[0].value, 1e-12);
}

TEST(Plastic, WarmTeethBearLess) {  // (3)
  double before = 1e300;
  for (const double celsius : {20.0, 45.0, 60.0, 99.0}) {
    RatingInput in = load();
    in.plastic.flank_temperature = {celsius, celsius};
    in.plastic.root_temperature = {celsius, celsius};
    const Rating r = rate(pair_17_39(), in).value();
    EXPECT_LT(r.S_F[1].value, before);
    before = r.S_F[1].value;
  }
}

TEST(Plastic, Refuses) {
  const RatedPair pair = pair_17_39();
  const auto field = [&](const RatingInput& in) { return rate(pair, in).error().field; };
  RatingInput in = load();
  in.materials[1] = testing::case_hardened();
  EXPECT_EQ(field(in), "rating.edition");
  in = load();
  in.plastic.ambient_temperature.reset();
  EXPECT_EQ(field(in), "rating.plastic.ambient_temperature");
  in = load();
  in.plastic.friction.reset();
  EXPECT_EQ(field(in), "rating.plastic.friction");
  in = load();
  in.speed.reset();
  EXPECT_EQ(field(in), "rating.speed");
  in = load(20.0);
  EXPECT_EQ(field(in), "gear2.material.temperatures");
  EXPECT_NE(rate(pair, in).error().message().find("100 °C"), std::string::npos);
  EXPECT_EQ(rate(pair, in).error().value, "");
}

}  // namespace
}  // namespace gearwright
