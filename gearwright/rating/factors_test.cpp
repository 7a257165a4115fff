// Branches of single factors are tested on both sides of each limit and against printed values.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/rating/testing/sample_pairs.hpp"

namespace gearwright {
namespace {

constexpr double kStep = 1e-9;

// ISO 1328-1:1995, grade 6, as the reports print them.
TEST(Accuracy, PrintedTolerances) {
  const RatedPair pair = testing::helical_24_95();
  const auto of = [&](std::size_t i) {
    return tolerances(RatingEdition::iso_2006, 6, pair.gears[i], 14, pair.alpha_t);
  };
  EXPECT_EQ(of(0).f_pt, 14);
  EXPECT_EQ(of(1).f_pt, 17);
  EXPECT_NEAR(of(0).f_pb, 13.10, 0.05);
  EXPECT_NEAR(of(1).f_pb, 15.90, 0.05);
  EXPECT_EQ(of(0).f_falpha, 18);
  EXPECT_EQ(of(1).f_falpha, 22);
  EXPECT_EQ(of(0).f_Hbeta, 18);
  EXPECT_EQ(of(1).f_Hbeta, 19);
}

TEST(Accuracy, GradesGrowBySqrtTwo) {
  const RatedPair pair = testing::helical_24_95();
  for (const auto edition : {RatingEdition::iso_2006, RatingEdition::iso_2019}) {
    double before = 0.0;
    for (int grade = kBestGrade; grade <= kWorstGrade; ++grade) {
      if (!has_class(tolerance_edition(edition), grade)) continue;
      const double f = tolerances(edition, grade, pair.gears[0], 14, pair.alpha_t).f_pt;
      EXPECT_GT(f, before);
      before = f;
    }
  }
}

DynamicInput sample_speed(double N) {
  DynamicInput d;
  d.specific_load = 500;
  d.c_prime = 14;
  d.c_gamma_alpha = 20;
  d.reduced_mass = 0.05;
  d.pitch_error = 12;
  d.profile_error = 15;
  d.tip_relief = 20;
  d.epsilon_gamma = 1.6;
  d.teeth = 20;
  d.speed = 1000;
  d.speed = N / dynamic_factor(d).N.value * 1000;
  return d;
}

TEST(DynamicFactor, RangesMeet) {
  for (const double N : {1.15, 1.5}) {
    const double below = dynamic_factor(sample_speed(N - kStep)).K_v.value;
    const double above = dynamic_factor(sample_speed(N + kStep)).K_v.value;
    EXPECT_NEAR(below, above, 1e-6) << N;
  }
  EXPECT_NEAR(dynamic_factor(sample_speed(1e-9)).K_v.value, 1.0, 1e-8);
  // At N = 0.85, the factor of the standard jumps to its value at resonance.
  EXPECT_GT(dynamic_factor(sample_speed(0.85 + 1e-6)).K_v.value,
            dynamic_factor(sample_speed(0.85 - 1e-6)).K_v.value);
}

TEST(DynamicFactor, NamesItsRange) {
  EXPECT_STREQ(dynamic_factor(sample_speed(0.5)).K_v.branch, "subcritical, N ≤ 0.85");
  EXPECT_STREQ(dynamic_factor(sample_speed(1.0)).K_v.branch, "main resonance, N_S < N ≤ 1.15");
  EXPECT_STREQ(dynamic_factor(sample_speed(1.3)).K_v.branch, "intermediate, 1.15 < N < 1.5");
  EXPECT_STREQ(dynamic_factor(sample_speed(2.0)).K_v.branch, "supercritical, N ≥ 1.5");
}

// Under a light load, resonance begins at a lower speed, N_S = 0.5 + 0.35 √(F_t K_A K_γ/(100 b)).
TEST(DynamicFactor, LightLoadsResonateEarlier) {
  DynamicInput d = sample_speed(0.8);
  EXPECT_STREQ(dynamic_factor(d).K_v.branch, "subcritical, N ≤ 0.85");
  d.specific_load = 36;
  EXPECT_DOUBLE_EQ(resonance_begin(36), 0.71);
  EXPECT_STREQ(dynamic_factor(d).K_v.branch, "main resonance, N_S < N ≤ 1.15");
}

TEST(RunningIn, ByKindAndSpeed) {
  const Material eh = testing::case_hardened();
  Material v = eh;
  v.kind = MaterialKind::through_hardened;
  v.sigma_Hlim = 700;
  EXPECT_NEAR(running_in({eh, eh}, 15.9, 20), 1.1925, 1e-12);
  EXPECT_NEAR(running_in({eh, v}, 20.7, 4.88), 3.142, 5e-4);  // printed
  EXPECT_NEAR(running_in({eh, v}, 27.0, 4.88), 4.098, 5e-4);  // printed
  EXPECT_EQ(running_in({eh, eh}, 100, 1), 3.0);
  EXPECT_NEAR(running_in({v, v}, 100, 7), 12800.0 / 700, 1e-12);
  EXPECT_NEAR(running_in({v, v}, 100, 12), 6400.0 / 700, 1e-12);
}

TEST(TransverseLoad, BranchesMeetAtTwo) {
  RatedPair pair = testing::helical_24_95();
  const auto at = [&](double e) {
    pair.epsilon_beta = e - pair.epsilon_alpha;
    return transverse_load(pair, 20, 30, 500, 0.8).K_Halpha.value;
  };
  EXPECT_NEAR(at(2 - kStep), at(2 + kStep), 1e-8);
}

// The branch names the deviations, because reports that use f_pb alone have a smaller factor.
TEST(TransverseLoad, TheBranchNamesItsDeviations) {
  RatedPair pair = testing::helical_24_95();
  for (const double e : {1.9, 2.1}) {
    pair.epsilon_beta = e - pair.epsilon_alpha;
    const auto t = transverse_load(pair, 20, 30, 500, 0.8);
    EXPECT_EQ(t.K_Halpha.branch,
              std::string(e < 2 ? "ε_γ ≤ 2" : "ε_γ > 2") + ", with the greater of f_pb and f_fα");
    EXPECT_EQ(std::string(t.K_Falpha.branch), t.K_Halpha.branch);
  }
}

TEST(TransverseLoad, StaysBetweenOneAndAllOnOnePair) {
  const RatedPair pair = testing::helical_24_95();
  const auto t = transverse_load(pair, 20, 500, 100, 0.827);
  EXPECT_NEAR(t.K_Halpha.value, pair.epsilon_gamma() / (pair.epsilon_alpha * 0.827 * 0.827), 1e-12);
  EXPECT_NEAR(t.K_Falpha.value, pair.epsilon_gamma() / (0.25 * pair.epsilon_alpha + 0.75), 1e-12);
  EXPECT_EQ(transverse_load(pair, 20, 0, 1000, 0.827).K_Halpha.value, 1.0);
}

TEST(FaceLoad, BranchesMeetWhereTheWholeFaceBears) {
  const RatedPair pair = testing::helical_24_95();
  PinionMounting m;
  m.bearing_span = 800;
  m.offset = 100;
  m.shaft_diameter = 250;
  m.manufacture = 0.0;
  const std::array materials{testing::case_hardened(), testing::case_hardened()};
  const auto at = [&](double f_ma, double load) {
    m.manufacture = f_ma;
    return face_load(pair, m, materials, load, 16, {18, 19}, 20).K_Hbeta.value;
  };
  double before = 0.0;
  for (double f = 0; f < 400; f += 0.5) {
    const double k = at(f, 300);
    EXPECT_GE(k, before);
    if (before > 0.0) {
      EXPECT_LT(k - before, 0.05);
    }
    before = k;
  }
  EXPECT_GT(before, 2.0);
}

TEST(ContactRatioFactor, BranchesMeetAtOneOverlap) {
  RatedPair pair = testing::helical_24_95();
  pair.epsilon_beta = 1 - kStep;
  const double z = contact_ratio_factor(pair).value;
  const double m = single_contact_factors(pair)[0].value;
  pair.epsilon_beta = 1 + kStep;
  EXPECT_NEAR(z, contact_ratio_factor(pair).value, 1e-8);
  EXPECT_NEAR(m, single_contact_factors(pair)[0].value, 1e-8);
}

// Gears 8:60, m_n = 3, x = 0.2/0.2. An independent program gives ρ_1C = 4.4853, ρ_1B = 1.9234 and N
// = 38.1249 mm. The tip of the wheel would touch at A. Because of undercut, contact begins after A.
TEST(SingleContactFactor, CountsFromTheEndsOfContactOfAnUndercutPinion) {
  const StraightRack rack = *iso53_rack("ISO53-A");
  const RatedPair pair = testing::printed_pair({8, 0.2, 0}, {60, 0.2, 0}, 3, 0, 30, 0, rack);
  EXPECT_LT(pair.epsilon_alpha, 1.2);
  const double at_C = 4.4853 * (38.1249 - 4.4853), at_B = 1.9234 * (38.1249 - 1.9234);
  EXPECT_NEAR(single_contact_factors(pair)[0].value, std::sqrt(at_C / at_B), 1e-4);
  // For the wheel, the outer point of single pair contact is also B.
  const double r_b2 = pair.gears[1].base_diameter / 2;
  EXPECT_NEAR(critical_section(pair, pair.gears[1])->d_en, 2 * std::hypot(r_b2, 38.1249 - 1.9234),
              1e-3);
}

// The effective ε_α of 5:60 is 1 near x1 = 0.5. For a smaller x1, single pair contact begins where
// the usable flank begins.
TEST(SingleContactFactor, HasNoJumpAtAContactRatioOfOne) {
  const StraightRack rack = *iso53_rack("ISO53-A");
  double before = 0.0;
  std::array<bool, 2> seen{};
  for (int k = 0; k <= 40; ++k) {
    const testing::PrintedGear g{5, 0.2 + 0.01 * k, 0};
    const RatedPair pair = testing::printed_pair(g, {60, 0.3, 0}, 2, 15, 20, 0, rack);
    const double z = single_contact_factors(pair)[0].value;
    seen[pair.epsilon_alpha < 1.0 ? 0 : 1] = true;
    if (pair.epsilon_alpha < 1.0) {
      const Gear pinion = make_gear(testing::printed_spec(g, 2, 15, 20, rack)).value();
      const double r_b = pair.gears[0].base_diameter / 2;
      const double N = pair.center_distance * std::sin(pair.alpha_wt);
      const double rho_C = r_b * std::tan(pair.alpha_wt);
      const double rho_B = std::sqrt(std::pow(*pinion.root_form_radius(), 2) - r_b * r_b);
      const double m = std::sqrt(rho_C * (N - rho_C) / (rho_B * (N - rho_B)));
      EXPECT_NEAR(z, m - pair.epsilon_beta * (m - 1), 1e-9 * m);
    }
    if (before > 0.0) {
      EXPECT_NEAR(std::log(z / before), 0.0, 0.1) << g.shift;
    }
    before = z;
  }
  EXPECT_TRUE(seen[0] && seen[1]);
}

TEST(SingleContactFactor, OnABaseCircleIsAnError) {
  const StraightRack rack = *iso53_rack("ISO53-A");
  RatedPair pair = testing::printed_pair({20, 0, 0}, {40, 0, 0}, 3, 0, 30, 0, rack);
  pair.epsilon_alpha = 0.5;
  pair.gears[0].tip_diameter = pair.gears[0].base_diameter * std::hypot(1.0, kPi / 20);
  EXPECT_EQ(single_contact_factors(pair)[0].value, kInfinity);
  const auto r = rate(pair, testing::helical_24_95_load());
  ASSERT_FALSE(r);
  EXPECT_EQ(r.error().field, "gear1.profile_shift");
}

TEST(SurfaceFactor, NamesTheLimitOfTheRoughness) {
  const Material steel = testing::case_hardened();
  EXPECT_STREQ(surface_factor(steel, 40.0).branch, "hardened or tempered");
  EXPECT_EQ(surface_factor(steel, 60.0).value, surface_factor(steel, 40.0).value);
  EXPECT_STREQ(surface_factor(steel, 60.0).branch,
               "hardened or tempered, Rz > 40 µm, so 40 µm is used");
}

TEST(FormFactor, LoadShareOfTheLaterEditionMeetsAtOneOverlap) {
  RatedPair pair = testing::helical_24_95();
  const auto at = [&](double overlap) {
    pair.epsilon_beta = overlap;
    const auto s = critical_section(pair, pair.gears[0]);
    return form_factor(RatingEdition::iso_2019, pair, *s).value;
  };
  EXPECT_NEAR(at(1 - kStep), at(1 + kStep), 1e-8);
}

TEST(Life, LinesAreContinuousAndFall) {
  for (int k = 0; k <= static_cast<int>(MaterialKind::plastic); ++k) {
    const auto kind = static_cast<MaterialKind>(k);
    for (const bool some : {false, true}) {
      double flank = 10, root = 10;
      for (double lg = 2; lg < 11; lg += 1e-3) {
        const double n = std::pow(10.0, lg);
        const double z = flank_life(kind, n, {.limited_pitting = some}).factor.value;
        const double y = root_life(kind, n, {.limited_pitting = some}).factor.value;
        EXPECT_LE(z, flank + 1e-12);
        EXPECT_LE(y, root + 1e-12);
        if (flank < 10) {
          EXPECT_LT(flank - z, 2e-3);
          EXPECT_LT(root - y, 2e-3);
        }
        flank = z;
        root = y;
      }
    }
  }
}

TEST(Life, PrintedValues) {
  using K = MaterialKind;
  EXPECT_NEAR(flank_life(K::case_hardened, 1.08e9).factor.value, 0.910, 5e-4);
  EXPECT_NEAR(flank_life(K::case_hardened, 1.783e8).factor.value, 0.962, 5e-4);
  EXPECT_NEAR(flank_life(K::case_hardened, 7782.3e6).factor.value, 0.857, 5e-4);
  EXPECT_NEAR(flank_life(K::through_hardened, 1506.3e6).factor.value, 0.901, 5e-4);
  EXPECT_NEAR(root_life(K::case_hardened, 7782.3e6).factor.value, 0.854, 5e-4);
  EXPECT_NEAR(root_life(K::case_hardened, 1297.1e6).factor.value, 0.886, 5e-4);
  EXPECT_NEAR(root_life(K::through_hardened, 1506.3e6).factor.value, 0.883, 5e-4);
}

// For a limited life, log σ_HG is linear in log N between the static stress and the reference
// stress.
TEST(Life, OtherFactorsCountByTheSameLine) {
  const Life a = flank_life(MaterialKind::case_hardened, 1e5);
  const Life b = flank_life(MaterialKind::case_hardened, 5e7);
  EXPECT_EQ(a.reference, 0.0);
  EXPECT_EQ(b.reference, 1.0);
  const double middle = std::sqrt(1e5 * 5e7);
  const Life m = flank_life(MaterialKind::case_hardened, middle);
  EXPECT_NEAR(m.reference, 0.5, 1e-12);
  EXPECT_NEAR(m.factor.value, std::sqrt(1.6), 1e-12);
}

TEST(RimFactor, ThinRims) {
  const RatedPair pair = testing::helical_24_95();
  const RatedGear& g = pair.gears[0];
  const double h = g.tooth_height;
  RatedGear ring = g;
  ring.teeth = -95;
  struct Case {
    const RatedGear* gear;
    double unit, least, thick, at_least;  // at_least: Y_B for the least rim thickness
  };
  for (const Case& c : {Case{&g, h, 0.5, 1.2, 1.6 * std::log(2.242 / 0.5)},
                        Case{&ring, 14.0, 1.75, 3.5, 1.15 * std::log(8.324 / 1.75)}}) {
    const auto factor = [&](double s) { return rim_factor(*c.gear, 14, s * c.unit).value; };
    EXPECT_EQ(rim_factor(*c.gear, 14, std::nullopt).value, 1.0);
    EXPECT_EQ(factor(c.thick + kStep), 1.0);
    EXPECT_NEAR(factor(c.thick - kStep), 1.0, 4e-3);
    EXPECT_EQ(least_rim(c.gear->side(), 14, h).thickness, c.least * c.unit);
    EXPECT_NEAR(factor(c.least), c.at_least, 1e-12);
    EXPECT_GT(factor(c.least), factor(0.6 * c.thick));
  }
}

TEST(DeepToothFactor, Branches) {
  RatedPair pair = testing::helical_24_95();
  const double c = std::cos(pair.beta_b);
  const auto at = [&](double e_n, int grade) {
    pair.epsilon_alpha = e_n * c * c;
    return deep_tooth_factor(pair, grade).value;
  };
  EXPECT_EQ(at(2.4, 5), 1.0);
  EXPECT_EQ(at(2.0, 4), 1.0);
  EXPECT_NEAR(at(2.05 + kStep, 4), 1.0, 1e-3);  // 1.0007, with the digits of the standard
  EXPECT_NEAR(at(2.5 - kStep, 4), 0.7, 2e-3);   // 0.701
  EXPECT_EQ(at(2.6, 4), 0.7);
}

TEST(Materials, TableHasItsReports) {
  const Material eh = testing::case_hardened();
  EXPECT_EQ(eh.sigma_Hlim, 1500);
  EXPECT_EQ(eh.sigma_Flim, 430);
  const Material v = *material_named("34CrNiMo6", 240 / 0.95);
  EXPECT_NEAR(v.sigma_Hlim, 700, 7);  // printed 700
  EXPECT_NEAR(v.sigma_Flim, 290, 5);  // printed 290
  EXPECT_FALSE(material_named("42CrMo4", 1000).has_value());
  for (const NamedMaterial& row : named_materials())
    EXPECT_TRUE(material_named(row.name).has_value()) << row.name;
}

// Values of elasticity and density exist for every kind of material except plastics.
TEST(Materials, PlasticsHaveNoUsualValues) {
  for (int k = 0; k <= static_cast<int>(MaterialKind::plastic); ++k) {
    const auto kind = static_cast<MaterialKind>(k);
    EXPECT_EQ(material_of_kind(kind).has_value(), kind != MaterialKind::plastic) << k;
  }
}

}  // namespace
}  // namespace gearwright
