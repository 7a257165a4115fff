// Compares crossed and parallel pairs of the engine with solids made of unwound strings, which are
// turned until they touch. Backlash, ratio, the line of action and its ends are compared. The
// oracle shares no code with the engine.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "gearwright/pair/pair.hpp"
#include "tests/oracle/touching_screws.hpp"
#include "tests/property/random_crossed.hpp"
#include "tests/property/random_pair.hpp"

namespace gearwright {
namespace {

using oracle::Side;
using property::CrossedSpecs;
using property::Random;

oracle::Screw screw(const BaseGear<double>& g, double tip_radius) {
  return {g.teeth, g.radius, g.tooth_thickness, g.helix_angle, tip_radius};
}

oracle::ScrewPair solids(const InvolutePair& p) {
  return {screw(p.input.gears[0], p.input.tip_form_radius[0]),
          screw(p.input.gears[1], p.input.tip_form_radius[1]), p.center_distance,
          p.shaft_angle.rad()};
}

// The flanks of these pairs touch along the whole line, because the oracle supports only involutes.
bool runs_cleanly(const InvolutePair& p) {
  return p.mesh.rho1_A > 0.02 * p.mesh.base_tangent_distance && p.mesh.rho2(p.mesh.rho1_E) > 0.1 &&
         p.mesh.path_ratio > 1.1;
}

double distance_to_line(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 d = (b - a).normalized();
  return (p - a - d * d.dot(p - a)).norm();
}

// All comparisons for one mounted pair and one rotation of gear 1.
void compare(const InvolutePair& p, double rotation_1) {
  const auto s = solids(p);
  const auto leading = oracle::touch(s, rotation_1, Side::leading);
  const auto trailing = oracle::touch(s, rotation_1, Side::trailing);
  ASSERT_TRUE(leading && trailing);
  ASSERT_EQ(leading->where, oracle::Where::flanks);
  ASSERT_EQ(trailing->where, oracle::Where::flanks);
  const double r_b2 = p.input.gears[1].radius;
  const double play = trailing->rotation_2 - leading->rotation_2;
  EXPECT_NEAR(play * r_b2, p.mesh.backlash.rotation[1] * r_b2, 1e-9);
  // Half the backlash is on each side of the rotation given by the ratio, so the poses are those of
  // the pair.
  const double ratio = p.input.gears[0].teeth / static_cast<double>(p.input.gears[1].teeth);
  const double middle = 0.5 * (leading->rotation_2 + trailing->rotation_2);
  EXPECT_NEAR((middle - ratio * rotation_1) * r_b2, 0.0, 1e-9);
  const double sine = std::sin(p.shaft_angle.rad());
  const double tolerance = 1e-10 / (sine * sine);
  const Vec3 A = p.on_line_of_action(p.mesh.rho1_A).r;
  const Vec3 E = p.on_line_of_action(p.mesh.rho1_E).r;
  EXPECT_LT(distance_to_line(leading->point, A, E), tolerance);
  EXPECT_LT(distance_to_line(trailing->point, p.on_trailing_line(p.mesh.rho1_A).r,
                             p.on_trailing_line(p.mesh.rho1_E).r),
            tolerance);
  // The point is the one with the curvature radius ρ_1, the free string of flank 1.
  EXPECT_LT((p.on_line_of_action(leading->string_1).r - leading->point).norm(), tolerance);
  EXPECT_NEAR(p.mesh.rho2(leading->string_1), leading->string_2, tolerance);
  const auto place = axial_place(p.mesh, leading->string_1);
  EXPECT_NEAR(leading->point.z(), place[0], tolerance);
  const Vec3 axis_2(0.0, std::sin(p.shaft_angle.rad()), std::cos(p.shaft_angle.rad()));
  EXPECT_NEAR((leading->point - Vec3(p.center_distance, 0, 0)).dot(axis_2), place[1], tolerance);
}

TEST(CrossedEngine, touches_as_the_solids_do) {
  Random random(301);
  int pairs = 0;
  for (int i = 0; i < 200 && pairs < 40; ++i) {
    const CrossedSpecs specs = property::random_crossed(random, 8.0);
    const auto p = mounted(specs, random.chance(0.5) ? 0.0 : 0.2 * random.unit());
    if (!p || !runs_cleanly(*p)) continue;
    ++pairs;
    for (const double turn : {0.0, 0.37, -0.81}) {
      compare(*p, turn * 2 * std::numbers::pi / p->input.gears[0].teeth);
      if (::testing::Test::HasFailure()) {
        ADD_FAILURE() << describe(specs) << "\n  rotation " << turn << " pitches";
        return;
      }
    }
  }
  EXPECT_EQ(pairs, 40);
}

// A flank leaves contact at E and enters it at A. Beyond these points, tooth 0 either touches with
// an edge or does not touch.
TEST(CrossedEngine, the_line_of_action_ends_where_the_solids_say) {
  Random random(302);
  int pairs = 0;
  for (int i = 0; i < 200 && pairs < 12; ++i) {
    const CrossedSpecs specs = property::random_crossed(random, 15.0);
    const auto p = mounted(specs);
    if (!p || !runs_cleanly(*p)) continue;
    ++pairs;
    const auto s = solids(*p);
    // Tooth 0 is at ρ_1 after gear 1 has turned by this angle from the point of half the backlash.
    const double v =
        p->input.gears[0].radius * std::pow(std::cos(p->input.gears[0].helix_angle), 2);
    const auto at_rest = oracle::touch_of_tooth(s, 0.0, Side::leading, 0);
    ASSERT_TRUE(at_rest) << describe(specs);
    if (at_rest->where != oracle::Where::flanks) continue;
    const auto where = [&](double rho1) {
      const auto t = oracle::touch_of_tooth(s, (rho1 - at_rest->string_1) / v, Side::leading, 0);
      return t && t->where == oracle::Where::flanks ? t->string_1 : -1.0;
    };
    const double step = 1e-3 * p->mesh.path_length;
    EXPECT_NEAR(where(p->mesh.rho1_A + step), p->mesh.rho1_A + step, 1e-8) << describe(specs);
    EXPECT_NEAR(where(p->mesh.rho1_E - step), p->mesh.rho1_E - step, 1e-8) << describe(specs);
    EXPECT_EQ(where(p->mesh.rho1_A - step), -1.0) << describe(specs);
    EXPECT_EQ(where(p->mesh.rho1_E + step), -1.0) << describe(specs);
  }
  EXPECT_EQ(pairs, 12);
}

// The same oracle on parallel axes gives the same law of backlash.
TEST(CrossedEngine, parallel_pairs_touch_as_the_solids_do) {
  Random random(303);
  int pairs = 0;
  for (int i = 0; i < 100 && pairs < 12; ++i) {
    const property::SpecPair specs = property::random_pair(random, false);
    const auto tight = property::mounted(specs);
    if (!tight) continue;
    const auto p = property::mounted(specs, tight->center_distance + 0.1 * random.unit());
    if (!p || !runs_cleanly(*p)) continue;
    ++pairs;
    auto s = solids(*p);
    s.half_face = p->mesh.overlap_ratio == 0.0 ? 0.0 : 5.0;
    const auto leading = oracle::touch(s, 0.1, Side::leading);
    const auto trailing = oracle::touch(s, 0.1, Side::trailing);
    ASSERT_TRUE(leading && trailing);
    const double play = trailing->rotation_2 - leading->rotation_2;
    EXPECT_NEAR(play, p->mesh.backlash.rotation[1], 1e-11) << describe(specs);
  }
  EXPECT_EQ(pairs, 12);
}

}  // namespace
}  // namespace gearwright
