// Tests the five equations on the case file, on closed forms, and in their fast form.
#include "tests/oracle/five_equation.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/oracle/circular_arc_cases.hpp"
#include "tests/oracle/five_equation_fast.hpp"
#include "tests/oracle/numbers.hpp"

namespace gearwright::oracle::tca {
namespace {

using nlohmann::json;

constexpr double kRotation = 1e-15;  // rad; the inputs of the file are doubles

#define EXPECT_CLOSE(value, wanted, tolerance) \
  EXPECT_NEAR(static_cast<double>((value) - (wanted)), 0.0, tolerance)

ArcPair case_named(const char* name) {
  for (const json& c : circular_arc_file().at("cases")) {
    if (c.at("name") == name) return arc_pair(c);
  }
  throw std::invalid_argument(name);
}

class ArcCases : public ::testing::TestWithParam<int> {
 protected:
  const json& file() const { return circular_arc_file().at("cases").at(GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(File, ArcCases, ::testing::Range(0, 18), [](const auto& info) {
  return circular_arc_file().at("cases").at(info.param).at("name").template get<std::string>();
});

TEST(CircularArcFile, HasNoOtherCases) { EXPECT_EQ(circular_arc_file().at("cases").size(), 18u); }

TEST_P(ArcCases, TouchWhereTheFileSays) {
  const ArcPair pair = arc_pair(file());
  ASSERT_FALSE(file().at("tca").empty());
  for (const json& row : file().at("tca")) {
    SCOPED_TRACE(row.at("phi1p").get<double>());
    const FiveEquationTouch t = arc_touch(pair, number(row, "phi1p"));
    EXPECT_TRUE(t.holds());
    EXPECT_CLOSE(t.at.rotation_2, number(row, "phi2p"), kRotation);
    EXPECT_CLOSE(t.transmission_error, number(row, "te_rad"), kRotation);
    EXPECT_CLOSE(t.at.s_1, number(row, "thF_deg") * kLongDegree, 1e-14);
    EXPECT_CLOSE(t.at.s_2, number(row, "thP_deg") * kLongDegree, 1e-14);
    EXPECT_CLOSE(rack_rotation(flank_1(pair), t.at.s_1, t.at.z_1), number(row, "phi1"), 1e-14);
    EXPECT_CLOSE(rack_rotation(flank_2(pair), t.at.s_2, t.at.z_2), number(row, "phi2"), 1e-14);
    EXPECT_CLOSE((t.point_f - vector(row, "point_f")).norm() / t.point_f.norm(), 0, 1e-14);
    EXPECT_CLOSE((t.point_1 - vector(row, "point_S1")).norm() / t.point_f.norm(), 0, 1e-14);
    EXPECT_CLOSE((t.point_2 - vector(row, "point_S2")).norm() / t.point_2.norm(), 0, 1e-14);
    EXPECT_CLOSE((t.normal_f - vector(row, "normal_f")).norm(), 0, 1e-14);
  }
}

TEST_P(ArcCases, OpenAsTheFileSays) {
  const json& c = file().at("contact");
  const FiveEquationTouch t = arc_touch(arc_pair(file()), number(c, "phi1p"));
  const Real k_1 = c.at("relative_principal").at(0).get<double>();
  const Real k_2 = c.at("relative_principal").at(1).get<double>();
  EXPECT_CLOSE(t.k_1 / k_1, 1, 1e-13);
  EXPECT_CLOSE(t.k_2 / k_2, 1, 1e-13);
  const Real delta = number(c, "delta");
  EXPECT_CLOSE(std::sqrt(2 * delta / t.k_1) / number(c, "semi_major"), 1, 1e-13);
  EXPECT_CLOSE(std::sqrt(2 * delta / t.k_2) / number(c, "semi_minor"), 1, 1e-13);
  EXPECT_CLOSE(t.major_angle, number(c, "major_angle_deg") * kLongDegree, 1e-14);
}

// The slope dφ_2/dφ_1 at 0 is compared with a central difference, whose error is of second order in
// its step.
TEST_P(ArcCases, SlopeOfTheFile) {
  const ArcPair pair = arc_pair(file());
  constexpr Real kStep = 1e-4L;
  const Real slope =
      (arc_touch(pair, kStep).transmission_error - arc_touch(pair, -kStep).transmission_error) /
      (2 * kStep);
  EXPECT_CLOSE(slope, number(file(), "te_slope_at_0"), 1e-11);
}

// The fast form, with an analytic Jacobian in double, agrees with the slow form if each position is
// computed from the last one.
TEST_P(ArcCases, FastFormStaysWithThem) {
  const ArcPair pair = arc_pair(file());
  const FastArcTouch fast(pair);
  FastArcTouch::Position x = FastArcTouch::from(pair, arc_touch(pair, 0)), before = x;
  constexpr int kSteps = 64;
  for (int i = 0; i <= kSteps; ++i) {
    const double rotation_1 = 0.3 * i / kSteps;
    const auto next = fast.solve(rotation_1, i < 2 ? x : FastArcTouch::beyond(before, x));
    before = x, x = next;
    ASSERT_TRUE(x.converged);
    EXPECT_LE(x.iterations, 4);
    if (i % 16 != 0) continue;
    const FiveEquationTouch slow = arc_touch(pair, rotation_1);
    const auto wanted = FastArcTouch::from(pair, slow);
    EXPECT_NEAR(x.rotation_2, wanted.rotation_2, kRotation);
    EXPECT_NEAR(x.rack_1, wanted.rack_1, 1e-13);
    EXPECT_NEAR(x.rack_2, wanted.rack_2, 1e-13);
    EXPECT_NEAR(x.theta_1, wanted.theta_1, 1e-12);
    EXPECT_NEAR(x.theta_2, wanted.theta_2, 1e-12);
    EXPECT_CLOSE((FastArcTouch::point_f(pair, rotation_1, x) - slow.point_f).norm() / pair.f.rho, 0,
                 3e-12);
    EXPECT_CLOSE(fast.heights(x).first, slow.at.z_1, 3e-12 * static_cast<double>(pair.f.rho));
    EXPECT_CLOSE(fast.heights(x).second, slow.at.z_2, 3e-12 * static_cast<double>(pair.f.rho));
  }
}

// All errors at once, with a shaft angle and a nearly equal crossing error, which together leave
// the axes nearly parallel, so that the arcs fit.
TEST(FiveEquationFast, CrossedAxes) {
  ArcPair pair = case_named("m10_30_150_all");
  pair.mounting.shaft_angle = 0.2L, pair.mounting.crossing += 0.2L + 1e-4L;
  const FiveEquationTouch slow = arc_touch(pair, 0.02L);
  ASSERT_TRUE(slow.solved);
  const auto x = FastArcTouch(pair).solve(0.02, FastArcTouch::from(pair, arc_touch(pair, 0.015L)));
  ASSERT_TRUE(x.converged);
  EXPECT_CLOSE(slow.at.rotation_2, x.rotation_2, kRotation);
  EXPECT_CLOSE(slow.at.s_1, x.theta_1, 1e-12);
}

// The crossing of axis 1 and the shaft angle are both rotations about x. If they are equal, they
// turn the whole arrangement.
TEST(FiveEquations, ShaftAngleUndoesCrossing) {
  ArcPair pair = case_named("m5_20_60_dC");
  const FiveEquationTouch plain = arc_touch(pair, 0.1L);
  const Real angle = 0.3L;
  pair.mounting.shaft_angle = pair.mounting.crossing = angle;
  const FiveEquationTouch turned_over = arc_touch(pair, 0.1L);
  ASSERT_TRUE(turned_over.holds());
  EXPECT_CLOSE(turned_over.at.rotation_2, plain.at.rotation_2, 1e-17);
  EXPECT_CLOSE((turned_over.point_f - crossed(angle) * plain.point_f).norm(), 0, 1e-14);
  EXPECT_CLOSE(turned_over.k_1 / plain.k_1, 1, 1e-13);
}

// Positions, normals and curvatures of single flanks and fillets. K is given in the basis of the
// rack: along the profile and along the tooth.
TEST(FlankSurface, AgreesWithTheFile) {
  ASSERT_EQ(circular_arc_file().at("surfaces").size(), 12u);
  for (const json& s : circular_arc_file().at("surfaces")) {
    const ArcFlank flank{s.at("gear"),
                         number(s, "rho"),
                         number(s, "a"),
                         number(s, "b"),
                         number(s, "lam_deg") * kLongDegree,
                         number(s, "r"),
                         false};
    const Real theta = number(s, "theta"), phi = number(s, "phi");
    const Real z = rack_height(flank, theta, phi);
    EXPECT_CLOSE(rack_rotation(flank, theta, z), phi, 1e-16);
    const FlankPlace p = arc_surface(flank)(theta, z);
    EXPECT_CLOSE((p.r - vector(s, "position")).norm() / p.r.norm(), 0, 1e-15);
    EXPECT_CLOSE((p.n - vector(s, "normal")).norm(), 0, 1e-15);
    const Matrix3 turn = turn_about_z(flank.gear == 1 ? phi : -phi);
    const Real sl = std::sin(flank.lead_angle), cl = std::cos(flank.lead_angle);
    const Vector3 t = turn * Vector3(std::cos(theta), std::sin(theta) * sl, -std::sin(theta) * cl);
    const Vector3 u = turn * Vector3(0, cl, sl);
    const Matrix2 k = curvature(p, t, u);
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) {
        EXPECT_CLOSE(k(i, j), s.at("K_t_u_basis").at(i).at(j).get<double>(), 1e-14);
      }
    }
  }
}

struct NamedSurface {
  std::string name;
  Surface surface;
  Real s, z;
};

std::vector<NamedSurface> surfaces() {
  const ArcFlank one{1, 7, 2.11L, 1.2L, 70 * kLongDegree, 53, false};
  const ArcFlank two{2, 7.75L, 2.76L, 1.6L, 70 * kLongDegree, 160, false};
  ArcFlank left = one, spur = two;
  left.mirrored = true, spur.lead_angle = 90 * kLongDegree;
  const InvoluteFlank screw{1, 23, 0.1L, 0.02L, 0.013L, -1};
  const InvoluteFlank mate{2, 41, 0.07L, 3.2L, -0.008L, -1};
  const InvoluteFlank trailing{1, 23, 0.1L, 0.02L, 0.0L, +1};
  const LeadTurn lead{3e-3L, 4e-4L};
  std::vector<NamedSurface> all = {{"arc 1", arc_surface(one), 0.5L, 7},
                                   {"arc 2", arc_surface(two), 0.6L, -5},
                                   {"left arc 1", arc_surface(left), 0.5L, 7},
                                   {"spur arc 2", arc_surface(spur), 0.4L, 3},
                                   {"screw 1", involute_surface(screw), 0.4L, 6},
                                   {"screw 2", involute_surface(mate), 0.3L, -8},
                                   {"trailing", involute_surface(trailing), 0.3L, 2}};
  for (std::size_t i = 0, n = all.size(); i < n; ++i) {
    all.push_back({all[i].name + " turned", turned(all[i].surface, lead), all[i].s, all[i].z});
  }
  return all;
}

// (1) n is a unit vector perpendicular to r_s and r_z    (2) derivatives agree with differences
// (3) K is symmetric                           (4) z is the third coordinate
TEST(FlankSurface, NormalsAndDerivatives) {
  constexpr Real kStep = 1e-5L;
  for (const NamedSurface& f : surfaces()) {
    SCOPED_TRACE(f.name);
    const FlankPlace p = f.surface(f.s, f.z);
    EXPECT_CLOSE(p.n.norm(), 1, 1e-18);  // (1)
    EXPECT_CLOSE(p.n.dot(p.r_s) / p.r_s.norm(), 0, 1e-18);
    EXPECT_CLOSE(p.n.dot(p.r_z), 0, 1e-17);
    const auto differ = [](const FlankPlace& a, const FlankPlace& b, const Vector3& r,
                           const Vector3& n) {
      EXPECT_CLOSE(((a.r - b.r) / (2 * kStep) - r).norm(), 0, 1e-8);
      EXPECT_CLOSE(((a.n - b.n) / (2 * kStep) - n).norm(), 0, 1e-8);
    };
    differ(f.surface(f.s + kStep, f.z), f.surface(f.s - kStep, f.z), p.r_s, p.n_s);  // (2)
    differ(f.surface(f.s, f.z + kStep), f.surface(f.s, f.z - kStep), p.r_z, p.n_z);
    const Vector3 e_1 = p.r_z.normalized(), e_2 = p.n.cross(e_1);
    const Matrix2 k = curvature(p, e_1, e_2);
    EXPECT_CLOSE(k(0, 1) - k(1, 0), 0, 1e-17);  // (3)
    EXPECT_EQ(p.r.z(), f.z);                    // (4)
  }
}

// The normal of the leading flank of gear 1 points out of its tooth. The next point of the outline,
// nearer to the centre of the tooth, lies behind the surface. For the flank of gear 2, the opposite
// is true.
TEST(FlankSurface, NormalsPointFromGear1ToGear2) {
  const FlankPlace one = involute_surface({1, 23, 0.1L, 0, 0.013L, -1})(0.4L, 0);
  EXPECT_LT(one.r.y(), 0);  // the clockwise flank of a tooth at +x
  EXPECT_LT(one.n.y(), 0);
  const FlankPlace two = involute_surface({2, 41, 0.07L, kLongPi, -0.008L, -1})(0.3L, 0);
  EXPECT_GT(two.r.y(), 0);  // the clockwise flank of a tooth at −x
  EXPECT_LT(two.n.y(), 0);
}

// The whole transmission error of one tooth pair of the long gears in the paper, which is the
// interior part of the saw tooth.
TEST(FiveEquations, CompositeInteriorOfTheFile) {
  int rows = 0;
  for (const json& composite : circular_arc_file().at("composite_te")) {
    const ArcPair pair = composite_pair(composite);
    for (const json& row : composite.at("rows")) {
      const auto best = carrying_arc_touch(pair, number(row, "phi1p_deg") * kLongDegree, 3);
      ASSERT_TRUE(best.has_value());
      EXPECT_EQ(best->pair, row.at("pair_interior").get<int>());
      EXPECT_CLOSE(best->touch.transmission_error, number(row, "te_interior_arcsec") * kArcsec,
                   kRotation);
      ++rows;
    }
  }
  EXPECT_EQ(rows, 50);
}

// Changing ρ_F and ρ_P by e leaves φ_2 unchanged and moves the point by e n.
TEST(FiveEquations, ParallelFlanks) {
  for (const char* name : {"m5_20_60_dC", "m5_20_60_crossing", "m4_16_48_bF0"}) {
    const ArcPair pair = case_named(name);
    ArcPair parallel = pair;
    const Real e = 0.3L;
    parallel.f.rho += e, parallel.p.rho += e;
    const FiveEquationTouch a = arc_touch(pair, 0.1L), b = arc_touch(parallel, 0.1L);
    EXPECT_CLOSE(a.at.rotation_2, b.at.rotation_2, 1e-17);
    EXPECT_CLOSE((b.point_f - a.point_f - e * a.normal_f).norm(), 0, 1e-15);
  }
}

// Changing a_F and a_P by d corresponds to φ_1′ − d/(r_1 sin λ) for gear 1 and φ_2′ − d/(r_2 sin λ)
// for gear 2.
TEST(FiveEquations, RackMovedAlongThePitchLine) {
  const ArcPair pair = case_named("m5_20_60_crossing");
  ArcPair moved = pair;
  const Real d = 0.4L, sl = std::sin(pair.lead_angle_f);
  moved.f.a += d, moved.p.a += d;
  const Real by_1 = d / (pair.pitch_radius_1 * sl), by_2 = d / (pair.pitch_radius_2 * sl);
  const Real there = arc_touch(moved, 0.1L).at.rotation_2;
  EXPECT_CLOSE(there, arc_touch(pair, 0.1L - by_1).at.rotation_2 + by_2, 1e-17);
}

// For a changed centre distance alone: (C_0 + w)² + (w cot θ sin λ)² = C², w = (ρ_F − ρ_P) sin θ −
// (b_F − b_P).
TEST(FiveEquations, CentreDistanceInOneEquation) {
  const ArcPair pair = case_named("m5_20_60_dC");
  const FiveEquationTouch t = arc_touch(pair, 0.2L);
  EXPECT_CLOSE(t.at.s_1, t.at.s_2, 1e-17);
  const Real w = (pair.f.rho - pair.p.rho) * std::sin(t.at.s_1) - (pair.f.b - pair.p.b);
  const Real across = w / std::tan(t.at.s_1) * std::sin(pair.lead_angle_f);
  const Mounting& m = pair.mounting;
  EXPECT_CLOSE(std::hypot(m.center_distance + w, across), m.center_distance + m.d_center, 1e-16);
}

// With opposite hands, the pair is the mirror image z → −z. The signs of crossing, tilt, axial
// shift and twists change, and nothing else changes.
TEST(FiveEquations, MirrorImage) {
  const ArcPair pair = case_named("m10_30_150_all");
  const FiveEquationTouch a = arc_touch(pair, 0.1L);
  FlankPair mirror = flank_pair(pair, nominal_theta(pair));
  ArcFlank one = flank_1(pair), two = flank_2(pair);
  one.mirrored = two.mirrored = true;
  mirror.flank_1 = turned(arc_surface(one), {-pair.lead_1.twist, 0});
  mirror.flank_2 = turned(arc_surface(two), {-pair.lead_2.twist, 0});
  mirror.mounting.crossing *= -1, mirror.mounting.intersecting *= -1, mirror.mounting.axial *= -1;
  const Unknowns start{a.at.s_1, -a.at.z_1 + 0.1L, a.at.s_2, -a.at.z_2, a.at.rotation_2 + 1e-4L};
  const FiveEquationTouch b = solve(mirror, 0.1L, start);
  ASSERT_TRUE(b.solved);
  EXPECT_CLOSE(b.at.rotation_2, a.at.rotation_2, 1e-17);
  EXPECT_CLOSE(b.at.z_1 + a.at.z_1, 0, 1e-14);
  EXPECT_CLOSE(b.k_1 / a.k_1, 1, 1e-13);
  EXPECT_CLOSE(b.major_angle + a.major_angle, 0, 1e-13);
}

// ΔC = 0.030 in: Newton's method finds a solution at 6.56°, beyond the undercut limit of gear 1 at
// 7.08°, where the flanks penetrate each other.
TEST(FiveEquations, FalseContactIsSeen) {
  ArcPair pair = case_named("ex1_consistent_75");
  pair.mounting.d_center = 0.030L;
  pair.f.theta_low = 7.08L * kLongDegree;
  const FiveEquationTouch t = arc_touch(pair, 0);
  EXPECT_TRUE(t.solved);
  EXPECT_NEAR(static_cast<double>(t.at.s_1 / kLongDegree), 6.56, 0.005);
  EXPECT_FALSE(t.opens);
  EXPECT_LT(t.k_1, 0);
  EXPECT_FALSE(t.within_outlines);
  EXPECT_FALSE(t.holds());
}

TEST(FiveEquations, BeyondTheFaceIsNoContact) {
  ArcPair pair = case_named("m5_20_60_crossing");
  const FiveEquationTouch free = arc_touch(pair, 0.3L);
  pair.half_face_1 = std::abs(free.at.z_1) + 0.01L;
  EXPECT_TRUE(arc_touch(pair, 0.3L).holds());
  pair.half_face_1 -= 0.02L;
  EXPECT_FALSE(arc_touch(pair, 0.3L).holds());
  EXPECT_TRUE(arc_touch(pair, 0.3L).solved);
}

}  // namespace
}  // namespace gearwright::oracle::tca
