// Ratings are compared value by value with printed reports of other programs, and the laws of the
// whole rating are tested.
#include "gearwright/rating/rating.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <type_traits>

#include "gearwright/base/units.hpp"
#include "gearwright/rating/testing/sample_pairs.hpp"

namespace gearwright {
namespace {

using testing::case_hardened;
using testing::printed_pair;

// Rating and RatedPair are not aggregates. C++20 would accept values for some members of an
// aggregate and set the others to 0.
static_assert(!std::is_constructible_v<Rating, RatingEdition>);
static_assert(!std::is_constructible_v<RatedPair, std::array<RatedGear, 2>>);

void expect_both(const FactorPair& got, double first, double second, double tolerance) {
  EXPECT_NEAR(got[0].value, first, tolerance);
  EXPECT_NEAR(got[1].value, second, tolerance);
}

// KISSsoft 03/2017, case KS-HEL-24-95 of the case file. Every value agrees to its printed digits,
// except the values that depend on the direction of the load, which are 0.1 % greater in the report
// (theory 11.6).
TEST(Rating, HelicalReport) {
  const RatedPair pair = testing::helical_24_95();
  EXPECT_NEAR(pair.epsilon_alpha, 1.463, 5e-4);
  EXPECT_NEAR(pair.epsilon_beta, 1.421, 5e-4);
  const Rating r = rate(pair, testing::helical_24_95_load()).value();
  EXPECT_NEAR(r.F_t.value, 240064.4, 0.5);
  EXPECT_NEAR(r.v->value, 20.83, 5e-3);
  EXPECT_NEAR(r.stiffness.c_prime.value, 13.832, 5e-4);
  EXPECT_NEAR(r.stiffness.c_gamma_alpha.value, 18.632, 5e-4);
  EXPECT_NEAR(r.stiffness.c_gamma_beta.value, 15.837, 5e-4);
  EXPECT_NEAR(r.m_red->value, 0.36503, 2e-5);
  EXPECT_NEAR(r.n_E1->value, 2843, 0.5);
  EXPECT_NEAR(r.N->value, 0.41, 5e-3);
  EXPECT_NEAR(r.K_v.value, 1.092, 5e-4);
  EXPECT_NEAR(r.K_Fbeta.value, 1.136, 6e-4);
  EXPECT_NEAR(r.K_Halpha.value, 1.069, 5e-4);
  EXPECT_NEAR(r.K_Falpha.value, 1.069, 5e-4);
  EXPECT_NEAR(r.Z_H.value, 2.307, 5e-4);
  EXPECT_NEAR(r.Z_E.value, 189.812, 5e-4);
  EXPECT_NEAR(r.Z_epsilon.value, 0.827, 5e-4);
  EXPECT_NEAR(r.Z_beta.value, 1.008, 5e-4);
  expect_both(r.Z_B, 1, 1, 0);
  EXPECT_NEAR(r.sigma_H0.value, 570.79, 0.01);
  expect_both(r.sigma_H, 739.61, 739.61, 0.05);
  EXPECT_NEAR(r.Z_L.value, 1.02, 5e-4);
  EXPECT_NEAR(r.Z_v.value, 1.022, 5e-4);
  EXPECT_NEAR(r.Z_R.value, 1.007, 5e-4);
  expect_both(r.Z_W, 1, 1, 0);
  expect_both(r.Z_NT, 0.85, 0.881, 5e-4);
  expect_both(r.sigma_HG, 1338.3, 1387.31, 0.05);
  expect_both(r.S_H, 1.81, 1.88, 5e-3);
  expect_both(r.Y_F, 1.18, 1.24, 5e-3);
  expect_both(r.Y_S, 2.28, 2.35, 7e-3);
  expect_both(r.Y_beta, 0.917, 0.917, 5e-4);
  expect_both(r.sigma_F0, 117.92, 127.69, 0.11);
  expect_both(r.sigma_F, 195.64, 211.85, 0.14);
  expect_both(r.Y_delta_relT, 1.001, 1.005, 5e-4);
  expect_both(r.Y_R_relT, 0.957, 0.957, 5e-4);
  expect_both(r.Y_X, 0.91, 0.91, 1e-12);
  expect_both(r.Y_NT, 0.85, 0.87, 5e-4);
  expect_both(r.sigma_FG, 637.15, 654.72, 0.02);
  expect_both(r.S_F, 3.26, 3.09, 5e-3);
  EXPECT_NEAR(r.N_L[0]->value, 12255.788e6, 2e6);
  EXPECT_NEAR(r.N_L[1]->value, 3096.199e6, 0.5e6);
  const std::array<std::array<double, 5>, 2> printed{
      {{31.18, 5.95, 14.06, 23.89, 369.487}, {32.75, 5.39, 16.11, 22.20, 1415.619}}};
  for (std::size_t i = 0; i < 2; ++i) {
    const CriticalSection& s = r.section[i];
    EXPECT_NEAR(s.s_Fn, printed[i][0], 5e-3);
    EXPECT_NEAR(s.rho_F, printed[i][1], 6e-3);
    EXPECT_NEAR(s.h_F, printed[i][2], 2.5e-3 * printed[i][2]);
    EXPECT_NEAR(s.alpha_Fen / kRadPerDeg, printed[i][3], 2.5e-3 * printed[i][3]);
    EXPECT_NEAR(s.d_en, printed[i][4], 1e-3);
  }
}

// Sun and planet of the second planetary stage of a 5 MW wind turbine, a spur pair. Every value
// agrees to its printed digits.
TEST(Rating, SpurReport) {
  const RatedPair pair = printed_pair({18, 0.389, 432.838}, {36, 0.5039, 815.663}, 21, 0, 550, 584,
                                      *iso53_rack("ISO53-A"));
  EXPECT_NEAR(pair.epsilon_alpha, 1.370, 5e-4);
  RatingInput in;
  in.torque = 285900.438 * 378.0 / 2000;
  in.speed = 246.7;
  in.application_factor = 1.25;
  in.mesh_load_factor = 1.10;
  in.dynamic_factor = 1.06;
  in.face_load_factor = 2.06;
  in.quality = {6, 6};
  in.viscosity = 220;
  in.flank_roughness = {4.8, 4.8};
  in.body = RatedBody{0.25, 3.5};
  in.materials = {case_hardened(), case_hardened()};
  const Rating r = rate(pair, in).value();
  EXPECT_NEAR(r.stiffness.c_prime.value, 12.240, 6e-4);
  EXPECT_NEAR(r.stiffness.c_gamma_alpha.value, 15.640, 5e-4);
  EXPECT_NEAR(r.stiffness.c_gamma_beta.value, 13.294, 5e-4);
  EXPECT_NEAR(r.v->value, 4.88, 5e-3);
  EXPECT_NEAR(r.K_Fbeta.value, 1.94, 5e-3);
  EXPECT_EQ(r.K_Halpha.value, 1.0);
  EXPECT_NEAR(r.Z_H.value, 2.25, 5e-3);
  EXPECT_NEAR(r.Z_epsilon.value, 0.936, 5e-4);
  expect_both(r.Z_B, 1.08, 1.00, 5e-3);
  EXPECT_NEAR(r.sigma_H0.value, 573.40, 0.01);
  EXPECT_NEAR(r.Z_v.value, 0.982, 5e-4);
  expect_both(r.Y_F, 1.47, 1.38, 5e-3);
  expect_both(r.Y_S, 2.04, 2.18, 5e-3);
  expect_both(r.sigma_F0, 73.95, 74.21, 0.01);
  const std::array<std::array<double, 4>, 2> printed{
      {{44.78, 9.52, 24.33, 25.74}, {47.70, 8.69, 25.73, 24.68}}};
  for (std::size_t i = 0; i < 2; ++i) {
    const CriticalSection& s = r.section[i];
    EXPECT_NEAR(s.s_Fn, printed[i][0], 5e-3);
    EXPECT_NEAR(s.rho_F, printed[i][1], 5e-3);
    EXPECT_NEAR(s.h_F, printed[i][2], 5e-3);
    EXPECT_NEAR(s.alpha_Fen / kRadPerDeg, printed[i][3], 5e-3);
  }
}

// Planet and ring of the second planetary stage of a 5 MW wind turbine, an internal pair. A pinion
// cutter with 30 teeth cuts the ring.
TEST(Rating, InternalReport) {
  RatedPair pair = printed_pair({36, 0.5039, 815.663}, {-93, 0.1171, 1906.081}, 21, 0, 550, 584,
                                *iso53_rack("ISO53-A"));
  RootTool& tool = pair.gears[1].tool;
  tool.fillet = 0.30;
  tool.cutter_teeth = 30;
  EXPECT_NEAR(pair.epsilon_alpha, 1.618, 5e-4);
  RatingInput in;
  in.torque = 285900.438 * 756.0 / 2000;
  in.speed = 4.88 * 60000 / (std::numbers::pi * 756.0);
  in.application_factor = 1.25;
  in.mesh_load_factor = 1.10;
  in.dynamic_factor = 1.06;
  in.face_load_factor = 1.15;
  in.quality = {6, 6};
  in.viscosity = 220;
  in.flank_roughness = {4.8, 8.0};
  in.root_roughness = {20, 20};
  in.body = RatedBody{0.25, 3.5};
  Material ring;
  ring.kind = MaterialKind::through_hardened;
  ring.sigma_Hlim = 700;
  ring.sigma_Flim = 290;
  ring.hardness_HV = 240 / 0.95;
  ring.yield_strength = 1000;
  in.materials = {case_hardened(), ring};
  const Rating r = rate(pair, in).value();
  EXPECT_NEAR(r.stiffness.c_prime.value, 14.053, 5e-4);
  EXPECT_NEAR(r.stiffness.c_gamma_alpha.value, 20.563, 2e-3);
  EXPECT_NEAR(r.K_Fbeta.value, 1.14, 5e-3);
  EXPECT_EQ(r.K_Halpha.value, 1.0);
  EXPECT_NEAR(r.Z_H.value, 2.85, 5e-3);
  EXPECT_NEAR(r.Z_epsilon.value, 0.891, 5e-4);
  expect_both(r.Z_B, 1, 1, 0);
  EXPECT_NEAR(r.sigma_H0.value, 312.44, 0.02);
  expect_both(r.sigma_H, 404.76, 404.76, 0.5);  // K_v is printed with two decimals
  EXPECT_NEAR(r.Z_L.value, 1.038, 5e-4);
  EXPECT_NEAR(r.Z_v.value, 0.961, 5e-4);
  EXPECT_NEAR(r.Z_R.value, 1.026, 5e-4);
  expect_both(r.Z_W, 1.0, 1.135, 5e-4);
  expect_both(r.Y_F, 1.01, 1.20, 5e-3);
  expect_both(r.Y_S, 2.48, 2.34, 5e-3);
  expect_both(r.sigma_F0, 61.98, 69.12, 0.02);
  EXPECT_NEAR(r.Y_delta_relT[1].value, 1.005, 5e-4);
  expect_both(r.Y_X, 0.840, 0.904, 5e-4);
  EXPECT_NEAR(r.section[1].s_Fn, 56.76, 5e-3);
  EXPECT_NEAR(r.section[1].rho_F, 8.78, 5e-3);
  EXPECT_NEAR(r.section[1].h_F, 30.32, 1.1e-2);
  EXPECT_NEAR(r.section[1].alpha_Fen / kRadPerDeg, 18.63, 5e-3);
  // R_zH of [T11.26] depends on all three inputs. Without one of them, Z_W is 1.
  for (const auto forget : {+[](RatingInput& some) { some.viscosity.reset(); },
                            +[](RatingInput& some) { some.flank_roughness.reset(); },
                            +[](RatingInput& some) { some.speed.reset(); }}) {
    RatingInput some = in;
    forget(some);
    some.dynamic_factor = r.K_v.value;
    expect_both(rate(pair, some).value().Z_W, 1.0, 1.0, 0);
  }
}

// ISO/TR 6336-30:2017, example 1.
TEST(Rating, ExampleOfTheTechnicalReport) {
  StraightRack rack;
  rack.dedendum = 1.4;
  rack.root_fillet_radius = 0.39;
  // The tip diameters of the example have two decimals, as on a drawing. They give the printed
  // digits. The tip diameters that the rack gives are 159.6601 and 872.3548, for which σ_H0 is
  // 1206.48.
  const RatedPair pair =
      printed_pair({17, 0.145, 159.66}, {103, 0.0, 872.35}, 8, 15.8, 100, 500, rack);
  EXPECT_NEAR(pair.gears[0].virtual_teeth, 18.905, 5e-4);
  EXPECT_NEAR(pair.gears[1].virtual_teeth, 114.543, 5e-4);
  RatingInput in;
  in.torque = 9000;
  in.speed = 360;
  in.face_load_factor = 1.16;
  in.life_h = 50000;
  in.viscosity = 320;
  in.quality = {5, 5};
  in.flank_roughness = {6, 6};
  in.tip_relief = 70;
  in.materials = {case_hardened(), case_hardened()};
  const Rating r = rate(pair, in).value();
  EXPECT_NEAR(r.F_t.value, 127352.0, 0.5);
  EXPECT_NEAR(r.v->value, 2.664, 5e-4);
  EXPECT_NEAR(r.Z_H.value, 2.39533, 5e-6);
  EXPECT_NEAR(r.Z_epsilon.value, 0.803, 5e-4);
  EXPECT_NEAR(r.Z_beta.value, 1.01944, 5e-6);
  EXPECT_NEAR(r.sigma_H0.value, 1206.58207, 2e-2);
  EXPECT_NEAR(r.stiffness.c_th.value, 17.85584, 5e-6);
  EXPECT_NEAR(r.stiffness.c_prime.value, 12.37047, 5e-6);
  EXPECT_NEAR(r.stiffness.c_gamma_alpha.value, 17.46485, 5e-5);
  EXPECT_NEAR(r.stiffness.c_gamma_beta.value, 14.84512, 5e-5);
  EXPECT_NEAR(r.K_v.value, 1.003, 1.5e-3);
  EXPECT_EQ(r.K_Halpha.value, 1.0);
  EXPECT_NEAR(r.K_Fbeta.value, 1.12803, 1e-3);
  EXPECT_NEAR(r.Z_L.value, 1.04739, 5e-6);
  EXPECT_NEAR(r.Z_v.value, 0.96911, 5e-6);
  EXPECT_NEAR(r.Z_R.value, 0.96599, 5e-6);
  expect_both(r.Z_NT, 0.91, 0.962, 5e-4);
}

// DIN 3990-11, z 19/104: the closed forms agree with the printed values to their last digits.
TEST(Rating, SpurSectionsOfDin3990) {
  StraightRack rack;
  rack.root_fillet_radius = 0.25;
  const RatedPair pair = printed_pair({19, 0.5, 0}, {104, 0.15, 0}, 4, 0, 48.64, 0, rack);
  EXPECT_NEAR(pair.center_distance, 248.506843355171, 1e-9);
  EXPECT_NEAR(pair.epsilon_alpha, 1.5363235945832296, 1e-9);
  EXPECT_NEAR(zone_factor(pair).value, 2.3959406670899934, 1e-9);
  EXPECT_NEAR(contact_ratio_factor(pair).value, 0.906214912960638, 1e-9);
  EXPECT_NEAR(single_contact_factors(pair)[0].value, 1.00554704549864, 1e-9);
  const auto s1 = critical_section(pair, pair.gears[0]);
  const auto s2 = critical_section(pair, pair.gears[1]);
  EXPECT_NEAR(s1->s_Fn, 8.748743355951145, 1e-4 * 8.7);
  EXPECT_NEAR(s2->s_Fn, 9.239504610725831, 1e-4 * 9.2);
  EXPECT_NEAR(s1->rho_F, 1.3161477577049423, 1e-4);
  EXPECT_NEAR(s2->rho_F, 1.325999192893118, 1e-4);
  EXPECT_NEAR(s1->q_s, 3.32361746799878, 3e-4);
  EXPECT_NEAR(s2->q_s, 3.48397821817927, 3e-4);
}

// m 8, 19/60, 250 N m: F_t K_A/b = 54.8 N/mm, so the main resonance begins at N_S = 0.76.
TEST(Rating, ResonanceOfLightLoadsIsNamed) {
  const RatedPair pair = printed_pair({19, 0.4, 0}, {60, 0.1, 0}, 8, 0, 90, 0, StraightRack());
  RatingInput in = testing::helical_24_95_load();
  in.torque = 250;
  in.speed = 6000;
  in.application_factor = 1.5;
  in.quality = {8, 8};
  in.body = {};
  const Rating light = rate(pair, in).value();
  EXPECT_NEAR(light.N->value, 0.82, 0.005);
  ASSERT_EQ(light.limits.size(), 1u);
  EXPECT_EQ(light.limits[0].code, WarningCode::rating_resonance);
  EXPECT_NE(light.limits[0].message.find("N_S = 0.76 < N = 0.82"), std::string::npos);
  in.torque = 1000;  // above 100 N/mm, N_S is 0.85
  EXPECT_TRUE(rate(pair, in).value().limits.empty());
}

// The default material has no strength, so all safety factors would be 0.
TEST(Rating, TorqueAndMaterialAreNeeded) {
  const RatedPair pair = testing::helical_24_95();
  RatingInput in = testing::helical_24_95_load();
  in.materials[1] = {};
  const auto without_material = rate(pair, in);
  ASSERT_FALSE(without_material);
  EXPECT_EQ(without_material.error().field, "gear2.material");
  EXPECT_EQ(without_material.error().kind, FailureKind::missing);
  for (const double torque : {0.0, -1.0, std::nan("")}) {
    in = testing::helical_24_95_load();
    in.torque = torque;
    const auto without_torque = rate(pair, in);
    ASSERT_FALSE(without_torque);
    EXPECT_EQ(without_torque.error().field, "rating.torque");
  }
}

// (1) twice the torque gives twice σ_F0 and √2 times σ_H0
TEST(RatingLaws, StressesFollowTheTorque) {
  const RatedPair pair = testing::helical_24_95();
  RatingInput in = testing::helical_24_95_load();
  const Rating once = rate(pair, in).value();
  in.torque *= 2;
  const Rating twice = rate(pair, in).value();
  EXPECT_DOUBLE_EQ(twice.sigma_H0.value, std::sqrt(2.0) * once.sigma_H0.value);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_DOUBLE_EQ(twice.sigma_F0[i].value, 2 * once.sigma_F0[i].value);
    // Load factors decrease as the load increases, so the stresses increase, but by less than the
    // load.
    EXPECT_GT(twice.sigma_F[i].value, once.sigma_F[i].value);
    EXPECT_LT(twice.sigma_F[i].value, 2 * once.sigma_F[i].value);
    EXPECT_LT(twice.S_H[i].value, once.S_H[i].value);
  }
}

// (2) k times the lengths and k³ times the torque give the same nominal stresses
TEST(RatingLaws, StressesHaveNoSize) {
  RatedPair pair = testing::helical_24_95();
  RatingInput in = testing::helical_24_95_load();
  const Rating small = rate(pair, in).value();
  constexpr double k = 2;
  pair.normal_module *= k;
  pair.face_width *= k;
  pair.center_distance *= k;
  for (RatedGear& g : pair.gears)
    for (double* length :
         {&g.reference_diameter, &g.base_diameter, &g.tip_diameter, &g.tip_form_diameter,
          &g.root_diameter, &g.tooth_height, &g.face_width, &g.bore})
      *length *= k;
  in.torque *= k * k * k;
  const Rating large = rate(pair, in).value();
  EXPECT_NEAR(large.sigma_H0.value, small.sigma_H0.value, 1e-9);
  EXPECT_NEAR(large.sigma_F0[0].value, small.sigma_F0[0].value, 1e-9);
  EXPECT_NEAR(large.sigma_F0[1].value, small.sigma_F0[1].value, 1e-9);
  EXPECT_NEAR(large.stiffness.c_prime.value, small.stiffness.c_prime.value, 1e-12);
}

// (3) exchanging gear 1 and gear 2 changes no number
TEST(RatingLaws, ExchangedGearsHaveTheSameNumbers) {
  const RatedPair pair =
      printed_pair({17, 0.3, 0}, {60, 0.1, 0}, 3, 15, 40, 0, *iso53_rack("ISO53-A"));
  const RatedPair other =
      printed_pair({60, 0.1, 0}, {17, 0.3, 0}, 3, 15, 40, 0, *iso53_rack("ISO53-A"));
  EXPECT_FALSE(pair.exchanged);
  EXPECT_TRUE(other.exchanged);
  RatingInput in = testing::helical_24_95_load();
  in.torque = 200;
  in.speed = 1500;
  in.quality = {6, 7};
  in.flank_roughness = {3, 5};
  in.materials = {case_hardened(), *material_named("42CrMo4")};
  const Rating a = rate(pair, in).value();
  in.torque *= 60.0 / 17.0;
  *in.speed *= 17.0 / 60.0;
  in.quality = {7, 6};
  in.flank_roughness = {5, 3};
  std::swap(in.materials[0], in.materials[1]);
  const Rating b = rate(other, in).value();
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(a.S_H[i].value, b.S_H[1 - i].value, 1e-9);
    EXPECT_NEAR(a.S_F[i].value, b.S_F[1 - i].value, 1e-9);
    EXPECT_NEAR(a.Z_W[i].value, b.Z_W[1 - i].value, 1e-12);
  }
  EXPECT_NEAR(a.K_v.value, b.K_v.value, 1e-12);
}

// More load, a less even load on the face, a longer life, rougher flanks, a coarser accuracy grade
// or alternating load never increase a safety factor.
TEST(RatingLaws, SafetiesFallWithEveryBurden) {
  const RatedPair pair = testing::helical_24_95();
  const RatingInput base = testing::helical_24_95_load();
  const Rating r = rate(pair, base).value();
  const auto no_safer = [&](const RatingInput& worse) {
    const Rating w = rate(pair, worse).value();
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_LE(w.S_H[i].value, r.S_H[i].value * (1 + 1e-12));
      EXPECT_LE(w.S_F[i].value, r.S_F[i].value * (1 + 1e-12));
    }
  };
  RatingInput in = base;
  in.application_factor = 1.5;
  no_safer(in);
  in = base;
  in.life_h = 200000;
  no_safer(in);
  in = base;
  in.face_load_factor = 1.3;
  no_safer(in);
  in = base;
  in.flank_roughness = {8, 8};
  in.root_roughness = {30, 30};
  no_safer(in);
  in = base;
  in.quality = {8, 8};
  no_safer(in);
  in = base;
  in.reversed = true;
  no_safer(in);
}

TEST(Rating, GivenFactorsStand) {
  RatingInput in = testing::helical_24_95_load();
  in.dynamic_factor = 1.2;
  in.transverse_load_factor = 1.3;
  in.transverse_load_factor_root = 1.4;
  in.face_load_factor_root = 1.11;
  const Rating r = rate(testing::helical_24_95(), in).value();
  EXPECT_EQ(r.K_v.value, 1.2);
  EXPECT_EQ(r.K_Halpha.value, 1.3);
  EXPECT_EQ(r.K_Falpha.value, 1.4);
  EXPECT_EQ(r.K_Fbeta.value, 1.11);
  EXPECT_STREQ(r.K_v.branch, kGivenFactor);
  EXPECT_STREQ(r.K_Falpha.branch, kGivenFactor);
}

TEST(Rating, WhatIsMissingIsNamed) {
  const RatedPair pair = testing::helical_24_95();
  const auto field = [&](const RatingInput& in) { return rate(pair, in).error().field; };
  RatingInput in = testing::helical_24_95_load();
  in.speed.reset();
  EXPECT_EQ(field(in), "rating.speed");
  in = testing::helical_24_95_load();
  in.quality.reset();
  EXPECT_EQ(field(in), "rating.quality");
  in.quality = {6, 12};
  EXPECT_TRUE(rate(pair, in));
  in.edition = RatingEdition::iso_2019;
  EXPECT_EQ(field(in), "rating.quality");
  in.quality = {11, 1};
  EXPECT_TRUE(rate(pair, in));
  in = testing::helical_24_95_load();
  in.face_load_factor.reset();
  EXPECT_EQ(field(in), "rating.face_load_factor");
}

// Differences of the edition of 2019: f_ε in Y_F, 1/cos³ β in Y_β, tolerances of ISO 1328-1:2013.
TEST(Rating, LaterEdition) {
  const RatedPair pair = testing::helical_24_95();
  RatingInput in = testing::helical_24_95_load();
  const Rating before = rate(pair, in).value();
  in.edition = RatingEdition::iso_2019;
  const Rating r = rate(pair, in).value();
  const double c = std::cos(10 * kRadPerDeg);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(r.Y_beta[i].value, before.Y_beta[i].value / (c * c * c), 1e-12);
    EXPECT_NEAR(r.Y_F[i].value, before.Y_F[i].value / std::sqrt(pair.epsilon_alpha_n()), 1e-12);
  }
  EXPECT_EQ(r.sigma_H0.value, before.sigma_H0.value);
}

}  // namespace
}  // namespace gearwright
