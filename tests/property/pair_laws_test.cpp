// Tests laws of a mounted pair on parallel axes over seeded pairs.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "gearwright/base/testing/numbers.hpp"
#include "gearwright/pair/drive.hpp"
#include "gearwright/pair/pair.hpp"
#include "tests/property/random_pair.hpp"

namespace gearwright::property {
namespace {

using testing::kEps;
constexpr int kPairs = 2000;

template <class Law>
int over_spec_pairs(std::uint64_t seed, Law law) {
  Random random(seed);
  int held = 0;
  for (int i = 0; i < kPairs; ++i) {
    const SpecPair specs = random_pair(random, i % 4 == 3);
    const auto pair = mounted(specs);
    if (!pair) continue;
    ++held;
    law(specs, *pair, random);
    if (::testing::Test::HasFailure()) {
      ADD_FAILURE() << "the pair: " << describe(specs) << "\n  a = " << pair->center_distance;
      break;
    }
  }
  return held;
}

// (1) at the backlash-free distance, j_bn = 0 within the rounding error of inv and its inverse,
//     measured on the base circles
TEST(PairLaws, no_backlash_at_the_backlash_free_distance) {
  const int held = over_spec_pairs(201, [](const SpecPair&, const ParallelPair& p, Random&) {
    EXPECT_NEAR(p.mesh.backlash.normal_base, 0.0,
                64 * kEps * (p.input.gears[0].radius + p.input.gears[1].radius));
    for (const Warning& w : p.warnings) EXPECT_NE(w.code, WarningCode::negative_backlash);
  });
  EXPECT_GT(held, kPairs / 2);
}

// (2) without allowances, this distance follows from the shifts, and the shifts follow from it
TEST(PairLaws, shifts_and_distance_are_inverse) {
  over_spec_pairs(202, [](const SpecPair& specs, const ParallelPair&, Random&) {
    SpecPair nominal = specs;
    nominal.first.thickness_allowance = nominal.second.thickness_allowance = 0.0;
    const auto p = mounted(nominal);
    if (!p) return;
    ShiftProblem problem;
    problem.z1 = specs.first.teeth;
    problem.z2 = specs.second.teeth;
    problem.normal_module = specs.first.normal_module;
    problem.normal_pressure_angle = specs.first.normal_pressure_angle;
    problem.helix_angle = {specs.first.helix_angle, specs.second.helix_angle};
    problem.x1 = specs.first.profile_shift;
    problem.x2 = specs.second.profile_shift;
    const auto solved = complete_shifts(problem);
    ASSERT_TRUE(solved);
    // da/dx is about m/sin α_wt. A rounding error of ε z in inv α_wt therefore causes an error of
    // this size.
    const double a = solved->center_distance;
    const double sin_w = p->mesh.base_tangent_distance / p->center_distance;
    const double z = std::abs(problem.z1) + std::abs(problem.z2);
    const double tolerance = 64 * kEps * z * problem.normal_module / (sin_w * sin_w);
    EXPECT_NEAR(a, p->center_distance, tolerance);
    problem.center_distance = a;
    problem.x2.reset();
    const auto back = complete_shifts(problem);
    ASSERT_TRUE(back);
    EXPECT_NEAR(back->x2, specs.second.profile_shift, tolerance / problem.normal_module);
    problem.mounting = Mounting::extended;
    const auto extended = complete_shifts(problem);
    ASSERT_TRUE(extended);
    const double sign = problem.z2 > 0 ? 1.0 : -1.0;
    EXPECT_NEAR(
        p->reference_center_distance + sign * problem.normal_module * (extended->x1 + extended->x2),
        a, 16 * kEps * a);
  });
}

// (3) if the two gears of an external pair are exchanged, everything with an index is exchanged
TEST(PairLaws, exchanging_the_gears) {
  over_spec_pairs(204, [](const SpecPair& specs, const ParallelPair& tight, Random& random) {
    if (tight.side() < 0.0) return;
    const double a = tight.center_distance + 0.1 * specs.first.normal_module * random.unit();
    const auto p = mounted(specs, a), q = mounted(SpecPair{specs.second, specs.first}, a);
    ASSERT_TRUE(p && q);
    const auto &m = p->mesh, &n = q->mesh;
    EXPECT_EQ(m.rack.sides[0].transverse_angle, n.rack.sides[0].transverse_angle);
    EXPECT_EQ(m.rack.sides[0].pitch_radius, n.rack.sides[1].pitch_radius);
    EXPECT_NEAR(m.path_length, n.path_length, 16 * kEps * a);
    EXPECT_NEAR(m.true_ratio, n.true_ratio, 64 * kEps * a / specs.first.normal_module);
    EXPECT_NEAR(m.backlash.normal_base, n.backlash.normal_base, 64 * kEps * a);
    EXPECT_NEAR(m.rho1_A, m.base_tangent_distance - n.rho1_E, 16 * kEps * a);
    EXPECT_NEAR(p->tip_clearance[0], q->tip_clearance[1], 16 * kEps * a);
    EXPECT_EQ(p->fillet_clearance[0].has_value(), q->fillet_clearance[1].has_value());
    EXPECT_EQ(p->interference.size(), q->interference.size());
    if (p->sliding_A.zeta_1 && q->sliding_E.zeta_2) {
      const double zeta = *p->sliding_A.zeta_1;
      // ρ_1 is a difference of two lengths of about the size of a.
      const double rho = contact_ends(*p)[0];
      EXPECT_NEAR(zeta, *q->sliding_E.zeta_2, 64 * kEps * a / rho * (1 + std::abs(zeta)));
    }
  });
}

// (4) backlash: its linear relations, and that it grows with the distance
TEST(PairLaws, backlash) {
  over_spec_pairs(205, [](const SpecPair& specs, const ParallelPair& tight, Random& random) {
    const bool external = tight.side() > 0.0;
    const double step =
        0.2 * specs.first.normal_module * (0.05 + random.unit()) * (external ? 1 : -1);
    const auto p = mounted(specs, tight.center_distance + step);
    if (!p) return;  // an internal gear does not always permit this distance
    const auto& m = p->mesh;
    EXPECT_GT(m.backlash.normal_base, 0.0);
    EXPECT_NEAR(m.backlash.rotation[0] * m.rack.sides[0].pitch_radius,
                m.backlash.circumferential[0], 8 * kEps * m.backlash.circumferential[0]);
    EXPECT_NEAR(m.backlash.rotation[1] * m.rack.sides[1].pitch_radius,
                m.backlash.circumferential[0], 8 * kEps * m.backlash.circumferential[0]);
    EXPECT_NEAR(m.backlash.normal * std::cos(m.rack.normal_pressure_angle), m.backlash.normal_base,
                8 * kEps * m.backlash.normal_base);
  });
}

// (5) A … E are in order; sliding is negative in the dedendum, positive in the addendum, 0 at C
TEST(PairLaws, path_of_contact) {
  over_spec_pairs(206, [](const SpecPair& specs, const ParallelPair& p, Random&) {
    const auto& m = p.mesh;
    const double p_bt = p.gears[0].reference().base_pitch_transverse;
    EXPECT_NEAR(m.rho1_D - m.rho1_A, p_bt, 16 * kEps * (std::abs(m.rho1_A) + p_bt));
    EXPECT_NEAR(m.rho1_E - m.rho1_B, p_bt, 16 * kEps * (m.rho1_E + p_bt));
    EXPECT_GE(m.rho1_true_begin, std::max(0.0, m.rho1_A));
    EXPECT_LE(m.rho1_true_end, m.rho1_E);
    EXPECT_LE(m.true_ratio, m.path_ratio + 4 * kEps);
    EXPECT_NEAR(m.path_ratio * p_bt, m.path_length, 8 * kEps * std::abs(m.path_length));
    EXPECT_NEAR(m.overlap_ratio,
                specs.first.face_width * std::abs(std::sin(specs.first.helix_angle.rad())) /
                    (std::numbers::pi * specs.first.normal_module),
                32 * kEps * (1 + m.overlap_ratio));
    // On undercut flanks, contact begins after A or ends before E.
    const auto [start, end] = contact_ends(p);
    if (start < m.rho1_C && p.sliding_A.zeta_1) {
      EXPECT_LT(*p.sliding_A.zeta_1, 0.0);
      EXPECT_GT(*p.sliding_A.zeta_2, 0.0);
    }
    if (end > m.rho1_C && p.sliding_E.zeta_1) {
      EXPECT_GT(*p.sliding_E.zeta_1, 0.0);
      EXPECT_LT(*p.sliding_E.zeta_2, 0.0);
    }
  });
}

// (6) the line of action touches both base circles, and its ends lie on the tip circles
TEST(PairLaws, line_of_action) {
  over_spec_pairs(207, [](const SpecPair&, const ParallelPair& p, Random&) {
    const double a = p.center_distance, scale = 64 * kEps * (a + p.input.tip_form_radius[1]);
    const Vec3 A = p.on_line_of_action(p.mesh.rho1_A).r, E = p.on_line_of_action(p.mesh.rho1_E).r;
    if ((E - A).norm() < 1e-3 * a) return;  // the direction is undefined
    const Vec3 d = (E - A).normalized();
    const double long_way = a / (E - A).norm();
    EXPECT_NEAR(std::abs(A.x() * d.y() - A.y() * d.x()), p.input.gears[0].radius, scale * long_way);
    EXPECT_NEAR(std::abs((A.x() - a) * d.y() - A.y() * d.x()), p.input.gears[1].radius,
                scale * long_way);
    EXPECT_NEAR(E.norm(), p.input.tip_form_radius[0], scale);
    // If the tip of an internal gear lies inside the base circle, there is no flank at the tip, and
    // the path ends at the base tangent point.
    const double tip_2 = std::max(p.input.tip_form_radius[1], p.input.gears[1].radius);
    EXPECT_NEAR((A - Vec3(a, 0, 0)).norm(), tip_2, scale * 4);
    EXPECT_EQ(p.on_trailing_line(p.mesh.rho1_A).r, Vec3(A.x(), 0.0 - A.y(), 0.0));
  });
}

// (7) if every length is doubled, every length of the mesh doubles exactly, and pure numbers do not
// change
TEST(PairLaws, scaling_by_two_is_exact) {
  over_spec_pairs(208, [](const SpecPair& specs, const ParallelPair& p, Random&) {
    SpecPair twice = specs;
    for (CylindricalSpec* s : {&twice.first, &twice.second}) {
      s->normal_module *= 2;
      s->thickness_allowance *= 2;
      s->face_width *= 2;
    }
    const auto q = mounted(twice);
    ASSERT_TRUE(q);
    EXPECT_EQ(q->center_distance, 2 * p.center_distance);
    EXPECT_EQ(q->mesh.path_length, 2 * p.mesh.path_length);
    EXPECT_EQ(q->mesh.true_ratio, p.mesh.true_ratio);
    EXPECT_EQ(q->mesh.overlap_ratio, p.mesh.overlap_ratio);
    EXPECT_EQ(q->tip_clearance[0], 2 * p.tip_clearance[0]);
    EXPECT_EQ(q->sliding_A.zeta_1, p.sliding_A.zeta_1);
    EXPECT_EQ(q->interference.size(), p.interference.size());
  });
}

// (8) spur is the limit of helical
TEST(PairLaws, spur_is_the_limit_of_helical) {
  over_spec_pairs(209, [](const SpecPair& specs, const ParallelPair&, Random&) {
    SpecPair spur = specs, helical = specs;
    spur.first.helix_angle = spur.second.helix_angle = Angle();
    helical.first.helix_angle = Angle::radians(1e-9);
    helical.second.helix_angle = Angle::radians(specs.second.teeth > 0 ? -1e-9 : 1e-9);
    const auto p = mounted(spur), q = mounted(helical);
    if (!p || !q) return;
    EXPECT_NEAR(p->center_distance, q->center_distance, 1e-12 * p->center_distance);
    EXPECT_NEAR(p->mesh.path_ratio, q->mesh.path_ratio, 1e-9);
    EXPECT_EQ(p->mesh.overlap_ratio, 0.0);
    EXPECT_LT(q->mesh.overlap_ratio, 1e-7);
  });
}

}  // namespace
}  // namespace gearwright::property
