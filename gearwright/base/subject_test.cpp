#include "gearwright/base/subject.hpp"

#include <gtest/gtest.h>

namespace gearwright {
namespace {

TEST(Subject, is_a_gear_and_a_member) {
  using M = GearMember;
  EXPECT_EQ(subject_of("gear1.tip_fillet.end_radius"), (Subject{1, M::tip_end_radius}));
  EXPECT_EQ(subject_of("gear2.profile_shift"), (Subject{2, M::profile_shift}));
  EXPECT_EQ(subject_of("bore.keyway_depth"), (Subject{0, M::keyway}));
  EXPECT_EQ(subject_of("gear2.thickness_allowance"), (Subject{2, M::thickness_allowance}));
  EXPECT_EQ(subject_of("pair.center_distance"), (Subject{0, M::center_distance}));
  EXPECT_EQ(subject_of("gear2"), (Subject{2, M::none}));
  EXPECT_EQ(subject_of(""), (Subject{0, M::none}));
}

TEST(Subject, of_another_field_is_no_member_of_this_table) {
  using M = GearMember;
  EXPECT_EQ(subject_of("gear1.cut_by.tip_diameter"), (Subject{1, M::other}));
  EXPECT_EQ(subject_of("pair.shaft_angle"), (Subject{0, M::other}));
  EXPECT_EQ(subject_of("gear12.teeth"), (Subject{0, M::other}));
  EXPECT_EQ(subject_of("gear1.teeth_max"), (Subject{1, M::other}));
}

}  // namespace
}  // namespace gearwright
