#include "gearwright/gear/basic.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/base/testing/numbers.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"

namespace gearwright {
namespace {

using testing::kDegree;

ReferenceInput<double> gear(int teeth, double beta_deg, double x) {
  return {teeth, 2.5, 20 * kDegree, beta_deg * kDegree, x, 0.0};
}

TEST(BaseGear, as_its_own_rack_is_what_it_was) {
  for (const int z : {1, 9, 40, -60}) {
    for (const double beta : {0.0, 15.0, -35.0, 70.0}) {
      const auto in = gear(z, beta, 0.3);
      const auto back = as_rack(base_gear(z, reference_geometry(in)), in.normal_pressure_angle);
      EXPECT_NEAR(back.normal_module, in.normal_module, 1e-14);
      EXPECT_NEAR(back.helix_angle, in.helix_angle, 1e-14);
      EXPECT_NEAR(back.profile_shift, in.profile_shift, 1e-12);
    }
  }
  EXPECT_EQ(as_rack(base_gear(20, reference_geometry(gear(20, 0, 0))), 0.3).helix_angle, 0.0);
}

TEST(BaseGear, another_rack_has_the_same_flanks) {
  const auto first = reference_geometry(gear(17, 25.0, 0.4));
  const auto other = as_rack(base_gear(17, first), 14.5 * kDegree);
  EXPECT_NE(other.profile_shift, 0.4);
  const auto second = reference_geometry(other);
  EXPECT_NEAR(second.base_diameter, first.base_diameter, 1e-13);
  EXPECT_NEAR(second.base_helix_angle, first.base_helix_angle, 1e-15);
  EXPECT_NEAR(second.base_tooth_thickness, first.base_tooth_thickness, 1e-13);
  EXPECT_NEAR(second.base_pitch_normal, first.base_pitch_normal, 1e-14);
}

TEST(BaseGear, steep_helices_have_flat_racks_only) {
  const BaseGear<double> worm{1, 10.0, 20.0, 80 * kDegree};
  EXPECT_FALSE(has_rack(worm, 20 * kDegree));
  EXPECT_TRUE(has_rack(worm, 9.9 * kDegree));
  EXPECT_FALSE(has_rack(worm, 10.1 * kDegree));
}

CylindricalSpec spec(int teeth, double x) {
  CylindricalSpec s = testing::plain_spec(
      {.teeth = teeth, .module = 2.5, .beta_deg = 20, .x = x, .face_width = 20.0});
  s.rack = *iso53_rack("ISO53-A");
  return s;
}

TEST(RackLeavingRoot, gives_back_the_rack_that_cut_it) {
  for (const double radius : {0.0, 0.2, 0.38}) {
    CylindricalSpec s = spec(40, 0.1);
    s.straight_rack().named = false;
    s.straight_rack().root_fillet_radius = radius;
    const auto made = make_gear(s);
    ASSERT_TRUE(made);
    const auto rack =
        rack_leaving_root(spec(40, 0.1), made->root_diameter, 2 * *made->root_form_radius());
    ASSERT_TRUE(rack) << rack.error().message();
    EXPECT_NEAR(rack->dedendum, 1.25, 1e-13);
    EXPECT_NEAR(rack->root_fillet_radius, radius, 1e-10);
  }
}

TEST(RackLeavingRoot, names_what_cannot_be) {
  EXPECT_EQ(rack_leaving_root(spec(40, 0.1), 200.0, std::nullopt).error().field, "root_diameter");
  const double d_f = spec(40, 0.1).normal_module * 40 / std::cos(20 * kDegree) - 5.0;
  EXPECT_EQ(rack_leaving_root(spec(40, 0.1), d_f, 500.0).error().field, "root_form_diameter");
  EXPECT_EQ(rack_leaving_root(spec(40, 0.1), d_f, 10.0).error().field, "root_form_diameter");
  EXPECT_EQ(rack_leaving_root(spec(-40, 0.1), 120.0, 118.0).error().field, "root_form_diameter");
  EXPECT_TRUE(rack_leaving_root(spec(-40, 0.1), 120.0, std::nullopt));
}

}  // namespace
}  // namespace gearwright
