// Tests laws of a gear over seeded gears: the effects of scaling, hand, shift and defaults.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "gearwright/base/testing/numbers.hpp"
#include "gearwright/gear/gear.hpp"
#include "tests/property/random_spec.hpp"

namespace gearwright::property {
namespace {

using testing::kEps;
constexpr int kGears = 4000;

std::optional<Gear> gear_if_made(const CylindricalSpec& spec) {
  auto made = make_gear(spec);
  if (!made) return std::nullopt;
  return std::move(made).take();
}

// Compares two outlines, one exactly `factor` times the other: arcs, ends and points in between.
bool scaled(const Gear& small, const Gear& large, double factor) {
  const GeneratedTooth &a = *small.tooth, &b = *large.tooth;
  if (a.outline.arcs.size() != b.outline.arcs.size()) return false;
  if (a.tip_radius * factor != b.tip_radius || a.root_radius * factor != b.root_radius)
    return false;
  for (std::size_t i = 0; i < a.outline.arcs.size(); ++i) {
    const Arc &p = a.outline.arcs[i], &q = b.outline.arcs[i];
    if (p.name != q.name || p.begin != q.begin || p.end != q.end) return false;
    for (const double u : {0.0, 0.3, 0.7, 1.0}) {
      if (p.point(u) * factor != q.point(u)) return false;
    }
  }
  return true;
}

// (1) if m_n and all given lengths are doubled, every length doubles exactly
TEST(GearLaws, scaling_by_two_is_exact) {
  Random random(101);
  int teeth = 0;
  for (int i = 0; i < kGears; ++i) {
    CylindricalSpec spec = random_spec(random);
    const auto one = gear_if_made(spec);
    spec.normal_module *= 2;
    spec.thickness_allowance *= 2;
    spec.face_width *= 2;
    if (spec.tip_diameter) spec.tip_diameter = 2 * *spec.tip_diameter;
    const auto two = gear_if_made(spec);
    ASSERT_EQ(one.has_value(), two.has_value()) << describe(spec);
    if (!one) continue;
    const auto &a = one->reference(), &b = two->reference();
    EXPECT_EQ(b.reference_diameter, 2 * a.reference_diameter);
    EXPECT_EQ(b.base_diameter, 2 * a.base_diameter);
    EXPECT_EQ(b.base_tooth_thickness, 2 * a.base_tooth_thickness);
    EXPECT_EQ(b.base_pitch_normal, 2 * a.base_pitch_normal);
    EXPECT_EQ(b.base_helix_angle, a.base_helix_angle);
    EXPECT_EQ(two->tip_diameter, 2 * one->tip_diameter);
    EXPECT_EQ(two->root_diameter, 2 * one->root_diameter);
    EXPECT_EQ(two->lead, 2 * one->lead);
    EXPECT_EQ(two->involute()->undercut_free_profile_shift,
              one->involute()->undercut_free_profile_shift);
    if (one->exists()) {
      ++teeth;
      EXPECT_TRUE(scaled(*one, *two, 2.0)) << describe(spec);
    }
  }
  EXPECT_GT(teeth, kGears / 3);
}

// (2) the hand of the helix has no effect in the transverse section
TEST(GearLaws, hand_changes_the_sign_of_lead_and_base_helix_only) {
  Random random(102);
  for (int i = 0; i < kGears; ++i) {
    CylindricalSpec spec = random_spec(random);
    const auto right = gear_if_made(spec);
    spec.helix_angle = -spec.helix_angle;
    const auto left = gear_if_made(spec);
    ASSERT_EQ(right.has_value(), left.has_value()) << describe(spec);
    if (!right) continue;
    EXPECT_EQ(left->lead, -right->lead);
    EXPECT_EQ(left->twist(), -right->twist());
    EXPECT_EQ(left->reference().base_helix_angle, -right->reference().base_helix_angle);
    EXPECT_EQ(left->reference().base_diameter, right->reference().base_diameter);
    EXPECT_EQ(left->tip_tooth_thickness_normal, right->tip_tooth_thickness_normal);
    EXPECT_EQ(left->warnings.size(), right->warnings.size());
    EXPECT_TRUE(scaled(*right, *left, 1.0)) << describe(spec);
  }
}

// (3) base cylinder and lead do not depend on the shift, the allowance or the depth of the rack
TEST(GearLaws, base_cylinder_is_the_rack_s_angle_and_nothing_else) {
  Random random(103);
  for (int i = 0; i < kGears; ++i) {
    CylindricalSpec spec = random_spec(random);
    const auto one = gear_if_made(spec);
    spec.profile_shift += random.uniform(-0.5, 0.5);
    spec.thickness_allowance += 0.01 * spec.normal_module;
    spec.tip_diameter.reset();
    spec.rack = StraightRack{};
    const auto two = gear_if_made(spec);
    if (!one || !two) continue;
    EXPECT_EQ(one->reference().base_diameter, two->reference().base_diameter);
    EXPECT_EQ(one->reference().base_helix_angle, two->reference().base_helix_angle);
    EXPECT_EQ(one->lead, two->lead);
  }
}

// (4) if the defaults are written out, nothing changes
TEST(GearLaws, defaults_written_out_change_nothing) {
  Random random(104);
  for (int i = 0; i < kGears; ++i) {
    CylindricalSpec spec = random_spec(random);
    spec.tip_diameter.reset();
    const auto absent = gear_if_made(spec);
    if (!absent || !(absent->tip_diameter > 0.0)) continue;
    spec.tip_diameter = absent->tip_diameter;
    const auto given = gear_if_made(spec);
    ASSERT_TRUE(given) << describe(spec);
    EXPECT_TRUE(scaled(*absent, *given, 1.0)) << describe(spec);
    EXPECT_NEAR(absent->tip_diameter,
                absent->reference_diameter +
                    2 * spec.normal_module * (spec.straight_rack().addendum + spec.profile_shift),
                4 * kEps * (std::abs(absent->tip_diameter) + absent->reference_diameter));
  }
}

// (5) an allowance acts as a shift: E_sn at x, and no allowance at x_E, cut the same flanks
TEST(GearLaws, allowance_is_a_shift_of_the_cutter) {
  Random random(105);
  for (int i = 0; i < kGears; ++i) {
    CylindricalSpec spec = random_spec(random);
    const auto allowed = gear_if_made(spec);
    if (!allowed || !allowed->exists()) continue;
    spec.tip_diameter = allowed->tip_diameter;
    spec.profile_shift = allowed->reference().generating_profile_shift;
    spec.thickness_allowance = 0.0;
    const auto shifted = gear_if_made(spec);
    ASSERT_TRUE(shifted && shifted->exists()) << describe(spec);
    EXPECT_TRUE(scaled(*allowed, *shifted, 1.0)) << describe(spec);
    EXPECT_NEAR(allowed->reference().base_tooth_thickness,
                shifted->reference().base_tooth_thickness,
                32 * kEps *
                    (allowed->reference().base_diameter +
                     std::abs(spec.profile_shift) * spec.normal_module));
  }
}

// (6) spur gears are the limit of helical ones: β = 1e-9 rad moves points by at most β times the
// size
TEST(GearLaws, spur_is_the_limit_of_helical) {
  Random random(106);
  int compared = 0;
  for (int i = 0; i < kGears; ++i) {
    CylindricalSpec spec = random_spec(random);
    spec.helix_angle = Angle();
    spec.rack = *iso53_rack("ISO53-A");
    spec.tip_diameter.reset();
    const auto spur = gear_if_made(spec);
    spec.helix_angle = Angle::radians(1e-9);
    const auto helical = gear_if_made(spec);
    // Within 1e-6 of the limit, the gear may be on either side of it.
    if (!spur || !helical || !spur->exists() || !helical->exists()) continue;
    if (spur->tooth->outline.arcs.size() != helical->tooth->outline.arcs.size()) continue;
    if (std::abs(*spur->involute()->undercut_free_profile_shift -
                 spur->reference().generating_profile_shift) < 1e-6)
      continue;
    ++compared;
    const double size = spur->reference_diameter + spur->tip_diameter;
    EXPECT_NEAR(spur->actual_tip_radius(), helical->actual_tip_radius(), 1e-9 * size)
        << describe(spec);
    for (std::size_t k = 0; k < spur->tooth->outline.arcs.size(); ++k) {
      const Vec2 p = spur->tooth->outline.arcs[k].point(0.5);
      const Vec2 q = helical->tooth->outline.arcs[k].point(0.5);
      EXPECT_LE((p - q).norm(), 1e-9 * size) << describe(spec) << " arc " << k;
    }
  }
  EXPECT_GT(compared, kGears / 3);
}

// (7) the finished flank is the involute of the gear: its half angles follow from the base
// thickness
TEST(GearLaws, flank_is_the_involute_of_the_base_thickness) {
  Random random(107);
  int compared = 0;
  for (int i = 0; i < kGears; ++i) {
    const CylindricalSpec spec = random_spec(random);
    const auto gear = gear_if_made(spec);
    if (!gear || !gear->exists()) continue;
    const Arc* flank = gear->tooth->outline.find(ArcName::flank);
    if (!flank) continue;
    const double d_b = gear->reference().base_diameter;
    for (const double u : {0.0, 0.5, 1.0}) {
      const Vec2 p = flank->curve->point(flank->begin + u * (flank->end - flank->begin));
      const double rho = std::max(p.norm(), d_b / 2);
      // Both half angles have rounding errors of a few ε of their sums. Near the base circle, the
      // roll angle is the square root of a difference, but the factor ξ³ keeps the error small.
      const double half = tooth_thickness_transverse(
                              spec.teeth, d_b, gear->reference().base_tooth_thickness, 2 * rho) /
                          (2 * rho);
      const double scale = 1 + rho / d_b + std::abs(gear->reference().base_tooth_thickness) / d_b +
                           std::abs(spec.profile_shift);
      EXPECT_NEAR(flank->curve->polar_angle(flank->begin + u * (flank->end - flank->begin)), half,
                  64 * kEps * scale)
          << describe(spec);
    }
    ++compared;
  }
  EXPECT_GT(compared, kGears / 4);
}

// (8) the shift without undercut is exact: above it, the flank is tangent to its fillet; below it,
//     the two form a corner
TEST(GearLaws, undercut_flag_tells_a_crossing_from_a_smooth_joint) {
  Random random(108);
  int smooth = 0, crossing = 0;
  for (int i = 0; i < kGears; ++i) {
    CylindricalSpec spec = random_spec(random);
    spec.rack = *iso53_rack(i % 2 ? "ISO53-A" : "ISO53-C");
    spec.tip_diameter.reset();
    const auto gear = gear_if_made(spec);
    if (!gear || !gear->exists()) continue;
    const double margin =
        gear->reference().generating_profile_shift - *gear->involute()->undercut_free_profile_shift;
    EXPECT_EQ(gear->undercut, margin < 0.0);
    const auto& arcs = gear->tooth->outline.arcs;
    for (std::size_t k = 1; k < arcs.size(); ++k) {
      if (arcs[k].name != ArcName::flank || arcs[k - 1].name != ArcName::root_fillet) continue;
      const double turn = std::remainder(
          arcs[k].at(0.0).tangent_angle - arcs[k - 1].at(1.0).tangent_angle, 2 * std::numbers::pi);
      if (margin > 1e-3) {
        ++smooth;
        EXPECT_NEAR(turn, 0.0, 1e-9) << describe(spec);
      } else if (margin < -1e-2) {
        ++crossing;
        EXPECT_LT(turn, -1e-4) << describe(spec);  // a corner that points outwards turns clockwise
      }
    }
  }
  EXPECT_GT(smooth, kGears / 10);
  EXPECT_GT(crossing, kGears / 40);
}

}  // namespace
}  // namespace gearwright::property
