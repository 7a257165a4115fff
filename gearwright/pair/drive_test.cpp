// Tests the axial force, the required face width and the growth of the backlash. The axial force is
// compared with the force along the contact normal, and the other two with a mounted pair.
#include "gearwright/pair/drive.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/contact/testing/sample_pairs.hpp"

namespace gearwright {
namespace {

ParallelPair mounted(const testing::SamplePair& p, double more = 0.0) {
  return testing::taken(mount_as<ParallelPair>(
      p.gears[0], p.gears[1], {.center_distance = p.place.center_distance + more}));
}

// [T6.15]: the force on gear 1 is opposite to the normal that points out of gear 1. The tangential
// force is the moment about axis 1 divided by the working pitch radius.
TEST(Drive, axial_force_is_that_of_the_contact_normal) {
  for (const int z2 : {41, -61}) {
    for (const double beta : {12.0, -20.0}) {
      const auto sample = testing::involutes(20, z2, beta);
      const ParallelPair pair = mounted(sample);
      ContactRequest request;
      request.rotations = {Angle::radians(0.03)};
      const ContactPoint at = analyse_contact(sample.pair(), request).positions[0];
      const Vec3 force = -at.normal;
      const double tangential = at.point.cross(force).z() / pair.mesh.rack.sides[0].pitch_radius;
      ASSERT_GT(tangential, 0.0);
      const auto [one, two] = axial_force(pair);
      EXPECT_NEAR(one, force.z() / tangential, 1e-12) << z2 << " " << beta;
      EXPECT_EQ(two, -one);
      EXPECT_EQ(one<0.0, beta> 0.0);  // a right-hand driver is pushed towards −z
    }
  }
}

// [T6.14]: with this face width, the total contact ratio has the requested value.
TEST(Drive, a_face_gives_the_contact_ratio_asked_for) {
  for (const int z2 : {41, -61}) {
    auto sample = testing::involutes(20, z2, 15);
    const double total = 2.7;
    const auto face = face_width_for_total(mounted(sample), total);
    ASSERT_TRUE(face);
    for (Gear& gear : sample.gears) gear.spec.face_width = *face;
    EXPECT_NEAR(mounted(sample).contact_ratio_true(), total, 1e-13);
    EXPECT_EQ(face_width_for_total(mounted(sample), 1.0), 0.0);
    EXPECT_FALSE(face_width_for_total(mounted(testing::involutes(20, z2, 0)), 2.7));
  }
}

// [T6.16]: from zero backlash, the backlash grows by 2 tan α_wt per mm of centre distance. For an
// internal pair, the centre distance decreases by 1 mm instead.
TEST(Drive, backlash_grows_with_the_distance) {
  for (const int z2 : {41, -61}) {
    const auto sample = testing::involutes(20, z2, 15);
    const double step = z2 > 0 ? 1e-5 : -1e-5;
    const double j = mounted(sample, step).mesh.backlash.circumferential[0];
    EXPECT_NEAR(j / step, backlash_per_distance(mounted(sample)), 1e-4);
  }
}

}  // namespace
}  // namespace gearwright
