#include "gearwright/gear/pinion_cut.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "gearwright/base/testing/draw.hpp"
#include "gearwright/base/testing/named_limit.hpp"
#include "gearwright/base/testing/taken.hpp"
#include "gearwright/gear/testing/made.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/math/involute.hpp"

namespace gearwright {
namespace {

using namespace literals;
using testing::made;

CylindricalSpec cutter_spec(int teeth, double x, Angle beta = 0_deg) {
  CylindricalSpec s =
      testing::plain_spec({.teeth = teeth, .module = 2.0, .x = x, .face_width = 20.0});
  s.helix_angle = beta;
  s.straight_rack().addendum = 1.25;
  return s;
}

// The paper's pinion of two teeth with both fillets.
CylindricalSpec two_teeth() {
  CylindricalSpec s = testing::plain_spec(
      {.teeth = 2, .module = 1.75, .beta_deg = 30, .x = 0.7, .face_width = 20.0});
  s.straight_rack().dedendum = 1.0;
  s.straight_rack().root_fillet_radius = 0.0;
  s.root_fillet = RootFilletSpec{0.01};
  s.tip_fillet = TipFilletSpec{TipFilletSpec::By::radius, 0.332};
  return s;
}

Gear cut(const Gear& cutter, const PinionCutSpec& s) {
  return testing::taken(make_pinion_cut_gear(cutter, s));
}

double distance(const Gear& cutter, int teeth, double x) {
  const auto e = generating_distance(cutter, teeth, x);
  EXPECT_TRUE(e) << e.error().message();
  return *e;
}

// The default tip is exactly the tip that the cutter leaves. The cutter therefore never shortens
// the blank, whatever the scale of all lengths is. With z = −62, a cutter of 31 teeth and the scale
// 7.3, a rounding error could otherwise shorten the blank.
TEST(PinionCutGear, no_rounding_decides_whether_the_default_tip_is_topped) {
  testing::Draw random(20261123);
  std::vector<double> scales{1.0, 7.3};
  for (int i = 0; i < 60; ++i) scales.push_back(std::exp(random.uniform(-3, 3)));
  for (const double scale : scales) {
    for (const int teeth : {-62, -61, 40, 63}) {
      for (const double x_0 : {0.0, 0.13, -0.21}) {
        CylindricalSpec c = cutter_spec(31, x_0);
        c.normal_module *= scale;
        c.face_width *= scale;
        const Gear cutter = made(c);
        const Gear gear = cut(cutter, {teeth, distance(cutter, teeth, 0.05), 20.0 * scale, {}});
        EXPECT_FALSE(gear.tooth->tip_cut_by_rack) << scale << " " << teeth << " " << x_0;
        EXPECT_FALSE(warns(gear, WarningCode::tip_cut_by_rack));
        // The cutter shortens a blank that is larger by any amount, but leaves a smaller blank
        // unchanged.
        const double side = teeth > 0 ? 1.0 : -1.0;
        PinionCutSpec blank{teeth, gear.cut_by->distance, 20.0 * scale, gear.tip_diameter};
        *blank.tip_diameter += side * 0.001 * scale;
        EXPECT_TRUE(cut(cutter, blank).tooth->tip_cut_by_rack);
        *blank.tip_diameter -= side * 0.002 * scale;
        EXPECT_FALSE(cut(cutter, blank).tooth->tip_cut_by_rack);
      }
    }
    // If the rack rounds the tips of the gear, the bottom land of the rack lies at the addendum.
    for (const int teeth : {17, 29, 64}) {
      for (const double x : {0.0, 0.1, 0.37}) {
        CylindricalSpec s = testing::plain_spec(
            {.teeth = teeth, .module = 2.0 * scale, .x = x, .face_width = 20.0 * scale});
        s.straight_rack().tip_fillet_radius = 0.1;
        EXPECT_FALSE(made(s).tooth->tip_cut_by_rack) << scale << " " << teeth << " " << x;
        s.straight_rack().tip_fillet_radius = 0.0;
        s.straight_rack().tool_addendum = 1.0;
        EXPECT_FALSE(made(s).tooth->tip_cut_by_rack) << scale << " " << teeth << " " << x;
        s.thickness_allowance =
            -0.05 * scale;  // the cutter goes deeper, and the blank is unchanged
        EXPECT_TRUE(made(s).tooth->tip_cut_by_rack);
      }
    }
  }
}

TEST(GeneratingDistance, gives_the_shift_back) {
  int gears = 0;
  for (const double beta : {0.0, 25.0}) {
    for (const double x_0 : {-0.2, 0.0, 0.3}) {
      const Gear cutter = made(cutter_spec(20, x_0, Angle::degrees(beta)));
      for (const int teeth : {12, 45, 300, -60, -27}) {
        for (const double x : {-0.4, 0.0, 0.5}) {
          const auto e = generating_distance(cutter, teeth, x);
          if (!e) continue;  // no working pressure angle
          const auto gear = make_pinion_cut_gear(cutter, {teeth, *e, 20.0, std::nullopt});
          if (!gear) continue;  // the shape of the tooth is not tested here
          ++gears;
          EXPECT_NEAR(gear->spec.profile_shift, x, 1e-11) << teeth << " " << x_0;
        }
      }
    }
  }
  EXPECT_GT(gears, 70);
}

// Without profile shift, cutter and gear roll on their reference circles. The allowance counts as
// profile shift.
TEST(GeneratingDistance, reference_circles_touch_without_shift) {
  EXPECT_NEAR(distance(made(cutter_spec(20, 0.0)), 45, 0.0), 65.0, 1e-13);
  EXPECT_NEAR(distance(made(cutter_spec(20, 0.0)), -60, 0.0), 40.0, 1e-13);
  EXPECT_NEAR(distance(made(cutter_spec(20, 0.3)), 45, -0.3), 65.0, 1e-13);
  CylindricalSpec thin = cutter_spec(20, 0.3);
  thin.thickness_allowance = -0.3 * 2 * 2.0 * std::tan(std::numbers::pi / 9);  // x_E = 0
  EXPECT_NEAR(distance(made(thin), 45, 0.0), 65.0, 1e-12);
}

TEST(GeneratingDistance, grows_with_the_shift_and_falls_on_a_ring) {
  const Gear cutter = made(cutter_spec(20, 0.1));
  for (double x = -0.5; x < 1.0; x += 0.1) {
    EXPECT_LT(distance(cutter, 45, x), distance(cutter, 45, x + 0.1));
    const auto ring = generating_distance(cutter, -60, x + 0.1);
    if (!ring) break;
    EXPECT_GT(distance(cutter, -60, x), *ring);
  }
}

// The limit in the error message is exact.
TEST(GeneratingDistance, refuses_a_shift_without_a_working_angle) {
  const Gear cutter = made(cutter_spec(20, 0.0));
  const auto refusal = [&](int teeth) {
    return [&cutter, teeth](double x) {
      const auto e = generating_distance(cutter, teeth, x);
      if (e) return std::string();
      EXPECT_EQ(e.error().field, "profile_shift");
      return e.error().message();
    };
  };
  const double least = named_limit(refusal(45), -5.0, "at least ");
  EXPECT_TRUE(generating_distance(cutter, 45, least + 1e-9));
  EXPECT_FALSE(generating_distance(cutter, 45, least - 1e-9));
  const double most = named_limit(refusal(-60), 5.0, "at most ");
  EXPECT_TRUE(generating_distance(cutter, -60, most - 1e-9));
  EXPECT_FALSE(generating_distance(cutter, -60, most + 1e-9));
}

// The gear meshes with its cutter at E without backlash, so the tooth thicknesses on the two pitch
// circles add up to one pitch.
TEST(PinionCut, meshes_with_its_cutter_without_backlash) {
  for (const double beta : {0.0, 30.0}) {
    const Gear cutter = made(cutter_spec(20, 0.2, Angle::degrees(beta)));
    for (const int teeth : {45, -60}) {
      const double e = distance(cutter, teeth, 0.1), side = teeth > 0 ? 1.0 : -1.0;
      const Gear gear = cut(cutter, {teeth, e, 20.0, std::nullopt});
      const double r_p = side * e * 20 / (20 + teeth), r_g = std::abs(e * teeth / (20 + teeth));
      const double inv_w = involute(std::acos(cutter.base_radius() / r_p));
      const double psi_0 =
          cutter.reference().base_tooth_thickness / cutter.reference().base_diameter;
      const double psi = gear.reference().base_tooth_thickness / gear.reference().base_diameter;
      const double thickness = 2 * r_p * (psi_0 - inv_w) + 2 * r_g * (psi - side * inv_w);
      EXPECT_NEAR(thickness, 2 * std::numbers::pi * r_p / 20, 1e-12) << beta << " " << teeth;
    }
  }
}

TEST(PinionCut, takes_module_angles_and_hand_from_the_cutter) {
  CylindricalSpec s = cutter_spec(20, 0.1, 25_deg);
  s.normal_pressure_angle = 22.5_deg;
  s.thickness_allowance = -0.05;
  const Gear cutter = made(s);
  for (const int teeth : {45, -60}) {
    const Gear gear = cut(cutter, {teeth, distance(cutter, teeth, 0.0), 12.0, std::nullopt});
    EXPECT_EQ(gear.spec.teeth, teeth);
    EXPECT_EQ(gear.spec.normal_module, 2.0);
    EXPECT_EQ(gear.spec.normal_pressure_angle.deg(), 22.5);
    EXPECT_EQ(gear.spec.helix_angle.deg(), teeth > 0 ? -25.0 : 25.0);
    EXPECT_EQ(gear.lead > 0.0, teeth < 0);
    EXPECT_EQ(gear.spec.face_width, 12.0);
    EXPECT_EQ(gear.spec.thickness_allowance, 0.0);
    EXPECT_FALSE(gear.spec.root_fillet || gear.spec.tip_fillet);
    ASSERT_TRUE(gear.cut_by);
    EXPECT_EQ(gear.cut_by->cutter_teeth, 20);
    EXPECT_FALSE(gear.involute()->undercut_free_profile_shift);
    EXPECT_NEAR(gear.reference().base_diameter,
                cutter.reference().base_diameter * std::abs(teeth) / 20, 1e-12);
  }
}

TEST(PinionCut, default_tip_and_root) {
  const Gear cutter = made(two_teeth());
  const Gear gear = cut(cutter, {60, 61.106, 20.0, std::nullopt});
  EXPECT_NEAR(gear.tip_diameter, 2 * 60.003256676448815912, 1e-12);
  EXPECT_NEAR(gear.root_diameter, 2 * 56.626120946732886764, 1e-12);
  EXPECT_NEAR(gear.spec.profile_shift, -1.5121460520946642347, 1e-12);
  EXPECT_TRUE(gear.tooth->rounded_tip);
  EXPECT_EQ(*gear.tip_tooth_thickness_normal, 0.0);
  const Gear low = cut(cutter, {60, 61.106, 20.0, 119.2});
  EXPECT_EQ(low.tip_diameter, 119.2);
  EXPECT_EQ(low.actual_tip_radius(), 59.6);
  EXPECT_NEAR(*low.root_form_radius(), *gear.root_form_radius(), 1e-13);
}

// If the tip of the cutter passes the base tangent point of the gear, the gear is undercut.
TEST(PinionCut, undercut_begins_at_the_base_tangent_point) {
  const Gear cutter = made(cutter_spec(40, 0.0));
  const double r_b0 = cutter.base_radius(), xi_a = std::sqrt(std::pow(42.5 / r_b0, 2) - 1);
  int undercut = 0, free = 0;
  for (int teeth = 8; teeth < 40; ++teeth) {
    const double e = 40.0 + teeth, r_b = teeth * std::cos(std::numbers::pi / 9);
    const double line = std::sqrt((e - r_b0 - r_b) * (e + r_b0 + r_b));
    const auto gear = make_pinion_cut_gear(cutter, {teeth, e, 20.0, std::nullopt});
    ASSERT_TRUE(gear) << teeth;
    if (!gear->exists()) continue;
    EXPECT_EQ(gear->undercut, r_b0 * xi_a > line) << teeth;
    ++(gear->undercut ? undercut : free);
    EXPECT_EQ(gear->undercut, warns(*gear, WarningCode::undercut)) << teeth;
  }
  EXPECT_GT(undercut, 3);
  EXPECT_GT(free, 3);
}

TEST(PinionCut, refusals_name_their_key) {
  const Gear cutter = made(cutter_spec(20, 0.0));
  const auto key = [&](const PinionCutSpec& s) {
    const auto gear = make_pinion_cut_gear(cutter, s);
    if (gear) return std::string("made");
    EXPECT_FALSE(gear.error().message().empty());
    EXPECT_NE(gear.error().message().find(gear.error().field), std::string::npos);
    return gear.error().field;
  };
  EXPECT_EQ(key({45, 65.0, 20.0, std::nullopt}), "made");
  EXPECT_EQ(key({0, 65.0, 20.0, std::nullopt}), "teeth");
  EXPECT_EQ(key({-20, 5.0, 20.0, std::nullopt}), "teeth");
  EXPECT_EQ(key({-7, 5.0, 20.0, std::nullopt}), "teeth");
  EXPECT_EQ(key({200'000, 65.0, 20.0, std::nullopt}), "cut_by");
  EXPECT_EQ(key({45, 65.0, 0.0, std::nullopt}), "face_width");
  EXPECT_EQ(key({45, 65.0, 20.0, 80.0}), "tip_diameter");
  EXPECT_EQ(key({-60, 40.0, 20.0, 130.0}), "tip_diameter");
  const auto small = make_pinion_cut_gear(cutter, {45, 50.0, 20.0, std::nullopt});
  ASSERT_FALSE(small);
  EXPECT_EQ(small.error().field, "cut_by");
  const double least = 65.0 * std::cos(std::numbers::pi / 9);
  EXPECT_NEAR(number_after(small.error().message(), "greater than "), least, 1e-4);
  const auto close = make_pinion_cut_gear(cutter, {45, least - 1e-8, 20.0, std::nullopt});
  ASSERT_FALSE(close);
  EXPECT_NEAR(number_after(close.error().message(), "greater than "), least, 1e-7);
  EXPECT_EQ(key({45, least * (1 - 1e-12), 20.0, std::nullopt}), "cut_by");
  EXPECT_EQ(key({45, least * (1 + 1e-3), 20.0, std::nullopt}), "made");
}

// The smallest internal gear that the error names is accepted.
TEST(PinionCut, ring_must_be_larger_than_its_cutter) {
  const Gear cutter = made(cutter_spec(20, 0.0));
  const auto error = generating_distance(cutter, -18, 0.0);
  ASSERT_FALSE(error);
  EXPECT_EQ(error.error().field, "teeth");
  const int least = static_cast<int>(number_after(error.error().message(), "at least "));
  EXPECT_EQ(least, -21);
  EXPECT_TRUE(generating_distance(cutter, least, 0.0));
  EXPECT_FALSE(generating_distance(cutter, least + 1, 0.0));
  EXPECT_NE(error.error().message().find("at most 17"), std::string::npos);
}

// The cutter of profile C has a rounding that begins at its tip circle and generates a branch
// without height. With 13, 15, 17, 26, 27 and 34 to 36 teeth, this branch must not count as the end
// of the tooth.
TEST(DefaultCutter, cuts_internal_gears_of_every_named_rack) {
  for (const char* name : {"ISO53-A", "ISO53-B", "ISO53-C", "ISO53-D"}) {
    for (int z = 10; z <= 60; ++z) {
      CylindricalSpec ring = cutter_spec(-z, 0.0);
      ring.rack = *iso53_rack(name);
      const auto cut = cut_by_default(made(ring));
      EXPECT_EQ(cut.has_value(), z >= 38)
          << name << " " << z;  // with fewer teeth the flanks are too short
      EXPECT_EQ(cut.has_value(), cut && cut->tooth);
    }
  }
}

}  // namespace
}  // namespace gearwright
